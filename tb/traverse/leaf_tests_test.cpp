// SPDX-License-Identifier: Apache-2.0
// Runs long.
// From leaves to tests and back: each context's tests in the model's order, and its leaf over after the last.
// Verilator: -GContexts=6
#include "traverse/leaf_tests.hpp"

#include "Vleaf_tests.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 6, kLeaves = 40;
constexpr std::uint64_t kPrimitives = 50;

class LeafTests : public testing::TestWithParam<Stalls> {
 protected:
  LeafTests() {
    header.lines.count = kLeaves;
    header.primitives = kPrimitives;
    dut->primitives_i = kPrimitives;
    dut->line_valid_i = dut->over_i = 0;
    dut->test_ready_i = 1;
    image.resize(kLeaves * LineBytes);
  }
  void put(int leaf, int place, prim_t number) {
    prim_slot_t slot;
    slot.number = number, slot.kind = number % 2, slot.a.x = static_cast<coord_t>(1000 * leaf + place), slot.c.z = rng() % 4096;
    store_record(&image[static_cast<std::size_t>(leaf * LineBytes + place * SlotBytes)], slot);
  }
  // Leaf 0 has no primitive, the others one or two; numbers from 0 up.
  void random_leaves() {
    for (int leaf = 0; leaf < kLeaves; ++leaf)
      for (int place = 0; place < 2; ++place) put(leaf, place, leaf == 0 || (place == 1 && rng() % 4 == 0) ? NoPrim : rng() % kPrimitives);
  }
  std::vector<prim_slot_t> tests_of(int leaf, prim_t ignore, error_t expected = ErrNone) {
    std::vector<prim_slot_t> tests;
    EXPECT_EQ(leaf_tests(image.data(), header, static_cast<line_t>(leaf), ignore, [&](const prim_slot_t& s) { tests.push_back(s); }), expected);
    return tests;
  }
  void offer(int ctx, int leaf, prim_t ignore) {
    dut->line_valid_i = 1, dut->line_ctx_i = ctx, dut->ignore_i = ignore;
    std::memcpy(&dut->line_i[0], &image[static_cast<std::size_t>(leaf * LineBytes)], LineBytes);
  }

  std::mt19937 rng{4};
  Dut<Vleaf_tests> dut;
  std::vector<std::uint8_t> image;
  image_header_t header;
};
INSTANTIATE_TEST_SUITE_P(Patterns, LeafTests, testing::ValuesIn(kStallPatterns));

TEST_P(LeafTests, MatchesModel) {
  struct Context {
    bool busy = false;
    std::deque<prim_slot_t> due;   // tests to come
    int under_way = 0;
  };
  random_leaves();
  std::vector<Context> contexts(kContexts);
  std::vector<int> flying;   // contexts of the tests under way, one entry a test
  Gate source(GetParam().source, GetParam().burst, 1), sink(GetParam().sink, GetParam().burst, 2), end(0.5, 8, 3);
  int offered = -1, leaf = 0, over = 0, tests = 0;
  prim_t ignore = 0;
  for (long cycle = 0; over < 8000; ++cycle) {
    ASSERT_LT(cycle, 200000) << "a leaf is never over";
    dut->line_valid_i = 0;
    const int ctx = static_cast<int>(rng() % kContexts);
    if (offered < 0 && source.open() && !contexts[ctx].busy) {
      offered = ctx, leaf = static_cast<int>(rng() % kLeaves), ignore = rng() % kPrimitives;
      const auto due = tests_of(leaf, ignore);
      contexts[ctx] = {.busy = true, .due = {due.begin(), due.end()}};
    }
    if (offered >= 0) offer(offered, leaf, ignore);
    dut->test_ready_i = sink.open();
    dut->over_i = 0;
    for (int way = 0; way < 2; ++way) {
      if (flying.empty() || !end.open()) continue;
      const std::size_t at = rng() % flying.size();
      dut->over_i |= 1 << way;
      dut->over_ctx_i[way] = flying[at];
      --contexts[flying[at]].under_way;
      flying.erase(flying.begin() + static_cast<long>(at));
    }
    dut.settle();
    ASSERT_EQ(dut->fault_o, ErrNone);
    if (dut->leaf_valid_o) {
      ++over;
      Context& c = contexts[dut->leaf_ctx_o];
      ASSERT_TRUE(c.busy && c.due.empty() && c.under_way == 0) << "the leaf of context " << int(dut->leaf_ctx_o) << " is not over";
      c.busy = false;
    }
    if (dut->test_valid_o && dut->test_ready_i) {
      Context& c = contexts[dut->test_ctx_o];
      ASSERT_FALSE(c.due.empty());
      ASSERT_EQ(to_text(get_port<prim_slot_t>(dut->test_prim_o)), to_text(c.due.front()));
      c.due.pop_front();
      ++c.under_way, ++tests;
      flying.push_back(dut->test_ctx_o);
    }
    if (dut->line_valid_i && dut->line_ready_o) offered = -1;
    dut.tick();
  }
  EXPECT_GT(tests, 10000);
}

TEST_F(LeafTests, ANumberOutOfRangeIsAnErrorInEitherSlot) {
  for (int place = 0; place < 2; ++place) {
    put(1, place, kPrimitives);
    put(1, 1 - place, kPrimitives - 1);
    tests_of(1, NoPrim, ErrPrimitive);
    offer(2, 1, NoPrim);
    dut.settle();
    EXPECT_EQ(dut->fault_o, ErrPrimitive);
    EXPECT_TRUE(dut->line_ready_o);
    dut.tick();
    dut->line_valid_i = 0;
    for (int i = 0; i < 5; ++i, dut.tick()) {
      dut.settle();
      EXPECT_EQ(dut->fault_o, ErrNone);
      EXPECT_FALSE(dut->test_valid_o || dut->leaf_valid_o);
    }
  }
}

// Lines of two primitives: a test in each cycle, the first one cycle after its line.
TEST_F(LeafTests, SendsOneTestACycle) {
  put(1, 0, 7), put(1, 1, 8);
  int tests = 0;
  for (int cycle = 0; cycle < 1 + 2 * kContexts; ++cycle) {
    if (cycle < 2 * kContexts) offer(cycle / 2, 1, NoPrim);
    else dut->line_valid_i = 0;
    dut.settle();
    if (cycle < 2 * kContexts) EXPECT_EQ(dut->line_ready_o, cycle % 2);
    EXPECT_EQ(dut->test_valid_o, cycle > 0);
    if (cycle > 0) EXPECT_EQ(get_port<prim_slot_t>(dut->test_prim_o).number, 7u + static_cast<unsigned>(tests++) % 2);
    dut.tick();
  }
  EXPECT_EQ(tests, 2 * kContexts);
}

// While a missed test ends in each cycle, the divided ones wait, and a leaf without a test behind them.
TEST_F(LeafTests, KeepsEveryEnd) {
  put(1, 0, 7), put(1, 1, 8), put(2, 0, NoPrim), put(2, 1, NoPrim);
  for (int ctx = 0; ctx < kContexts - 1; ++ctx) {
    offer(ctx, 1, NoPrim);
    dut.tick(), dut.tick();
  }
  offer(kContexts - 1, 2, NoPrim);
  std::vector<int> over;
  for (int cycle = 0; cycle < 2 * kContexts; ++cycle) {
    dut->over_i = cycle < kContexts - 1 ? 3 : 0;
    dut->over_ctx_i[0] = dut->over_ctx_i[1] = cycle;
    dut.settle();
    if (dut->leaf_valid_o) over.push_back(dut->leaf_ctx_o);
    const bool taken = dut->line_ready_o;
    EXPECT_EQ(taken, cycle == 2 * (kContexts - 1));
    dut.tick();
    if (taken) dut->line_valid_i = 0;
  }
  EXPECT_EQ(over, (std::vector{0, 1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace castray::tb
