// SPDX-License-Identifier: Apache-2.0
// Contexts go to lines and get them: each its own, whatever the memory's stalls; none behind the section.
// Verilator: -GContexts=6 -GLines=16
#include "Vline_fetch.h"
#include "line_memory_model.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 6;
constexpr line_no_t kBase = 1000, kCount = 60;

line_data_t line_of(line_no_t line) {
  line_data_t data;
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::uint32_t>(line * 2654435761u + i);
  return data;
}

class LineFetch : public testing::TestWithParam<Stalls> {
 protected:
  LineFetch() {
    dut->base_i = kBase;
    dut->count_i = kCount;
    dut->visit_valid_i = dut->fill_valid_i = dut->req_ready_i = 0;
    dut->out_ready_i = 1;
  }
  // One cycle of the memory; the other inputs are set. True if a line came out, of context `ctx`.
  bool cycle(LineMemoryModel& memory) {
    memory.drive(dut);
    dut.settle();
    faulted = dut->fault_o != ErrNone;
    if (faulted) EXPECT_EQ(dut->fault_o, ErrNode);
    const bool out = dut->out_valid_o && dut->out_ready_i;
    if (out) ctx = dut->out_ctx_o, got_index = static_cast<int>(dut->out_index_o), std::memcpy(data.data(), &dut->out_data_o[0], sizeof data);
    hits += dut->hit_o, misses += dut->miss_o, waits += dut->wait_o;
    memory.observe(dut);
    dut.tick();
    dut->visit_valid_i = 0;
    return out;
  }
  // From the step of the even contexts, or that of the odd.
  void visit(int of, line_t index) {
    const int step = of % 2;
    ref_t ref;
    ref.kind = RefNode, ref.index = index;
    dut->visit_valid_i |= 1 << step, dut->visit_ctx_i[step] = of;
    set_port(dut->visit_ref_i[step], ref);
  }
  Dut<Vline_fetch> dut;
  int ctx = 0, got_index = 0;
  line_data_t data;
  bool faulted = false;
  long hits = 0, misses = 0, waits = 0;
};
INSTANTIATE_TEST_SUITE_P(Patterns, LineFetch, testing::ValuesIn(kStallPatterns));

TEST_P(LineFetch, GivesEachContextItsLine) {
  std::mt19937 rng(1);
  LineMemoryModel memory(line_of, GetParam(), 7);
  Gate sink(GetParam().sink, GetParam().burst, 3);
  std::vector<int> index(kContexts, -1);
  int given = 0, faults = 0, behind = 0;
  for (long cycles = 0; given < 5000; ++cycles) {
    ASSERT_LT(cycles, 600000) << "contexts wait for ever";
    for (int step = 0; step < 2; ++step) {
      const int of = step + 2 * static_cast<int>(rng() % (kContexts / 2));
      if (index[of] >= 0) continue;
      const bool outside = rng() % 100 == 0;
      const line_t to = outside ? kCount + (rng() % 3) * rng() % 100000 : rng() % kCount;
      visit(of, to);
      if (outside) ++behind;
      else index[of] = static_cast<int>(to);
    }
    dut->out_ready_i = sink.open();
    if (cycle(memory)) {
      ASSERT_GE(index[ctx], 0) << "context " << ctx << " asked for nothing";
      ASSERT_EQ(got_index, index[ctx]);
      ASSERT_EQ(data, line_of(kBase + static_cast<line_no_t>(index[ctx])));
      index[ctx] = -1;
      ++given;
    }
    faults += faulted;
  }
  dut->out_ready_i = 1;
  for (int i = 0; i < 1000; ++i) {
    if (cycle(memory)) index[ctx] = -1;
    faults += faulted;
  }
  EXPECT_EQ(std::count(index.begin(), index.end(), -1), kContexts) << "a line was lost";
  EXPECT_EQ(faults, behind);
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
  EXPECT_GE(misses, memory.requests);
}

TEST_F(LineFetch, TheLastLineIsInside) {
  LineMemoryModel memory(line_of, {}, 1);
  visit(3, kCount - 1);
  for (int cycles = 0; !cycle(memory) && cycles < 1000; ++cycles) EXPECT_FALSE(faulted);
  EXPECT_EQ(data, line_of(kBase + kCount - 1));
  visit(3, kCount);
  cycle(memory);
  cycle(memory);
  EXPECT_TRUE(faulted);
}

// 5 cycles with the queue's, one line a cycle.
TEST_F(LineFetch, ServesALineItHoldsInFiveCycles) {
  LineMemoryModel memory(line_of, {}, 1);
  visit(0, 5);
  for (int cycles = 0; !cycle(memory) && cycles < 1000;) ++cycles;
  const long before = hits;
  waits = 0;
  int given = 0;
  for (int i = 0; i < 5 + 20; ++i) {
    if (i < 20) visit(i % kContexts, 5);
    const bool out = cycle(memory);
    EXPECT_EQ(out, i >= 5);
    given += out;
  }
  EXPECT_EQ(given, 20);
  EXPECT_EQ(hits - before, 20);
  EXPECT_EQ(waits, 0);
}

TEST_F(LineFetch, AllContextsWaitForOneLine) {
  LineMemoryModel memory(line_of, {}, 1);
  for (int of = 0; of < kContexts; ++of) visit(of, 9), cycle(memory);
  int given = 0;
  for (int i = 0; i < 400; ++i) given += cycle(memory);
  EXPECT_EQ(given, kContexts);
  EXPECT_EQ(memory.requests, 1);
}

}  // namespace
}  // namespace castray::tb
