// SPDX-License-Identifier: Apache-2.0
// The brute-force walk: every primitive meets every context exactly once, in order, and the
// phases follow each other whatever the lanes and the reader do.
// Verilator: -GLanes=2
#include "Vbrute_walk.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

// Two lanes with `used` rays in the first, behind the walk's ports.
struct Bench {
  explicit Bench(double stall) : gate(stall, 1, 7) {
    dut->exhausted_i = 0;
    dut->starved_i = 0;
    dut->used_i = 0;
    dut->full_i = 0;
    dut->quiet_i = 3;
    dut->empty_i = 3;
    dut->reader_done_i = 0;
    dut->prim_valid_i = 0;
    dut->test_ready_i = 3;
  }

  // One batch: returns the (primitive, context) pairs in the order of the tests.
  std::vector<std::pair<int, int>> batch(int used, int primitives) {
    std::vector<std::pair<int, int>> tests;
    dut->used_i = used;
    dut->full_i = 3;
    dut->empty_i = 0;
    dut.settle();
    EXPECT_TRUE(dut->reader_start_o);
    dut.tick();
    int sent = 0;
    for (int cycle = 0; cycle < 200 + 8 * used * primitives; ++cycle) {
      dut->prim_valid_i = sent < primitives && gate.open();
      prim_slot_t slot;
      slot.number = 100 + sent;
      set_port(dut->prim_i, slot);
      dut->test_ready_i = gate.open() ? 3 : 1 + cycle % 2;
      dut->reader_done_i = sent == primitives;
      dut.settle();
      if (dut->emit_o) break;
      EXPECT_FALSE(dut->fill_o);
      EXPECT_EQ(dut->test_stall_o, dut->test_valid_o && dut->test_ready_i != 3);
      if (dut->test_valid_o && dut->test_ready_i == 3)
        tests.emplace_back(get_port<prim_slot_t>(dut->test_prim_o).number - 100, dut->test_ctx_o);
      if (dut->prim_valid_i && dut->prim_ready_o) ++sent;
      // Quiet only some time after the last test.
      dut->quiet_i = sent == primitives && !dut->test_valid_o && gate.open() ? 3 : 1;
      dut.tick();
    }
    EXPECT_TRUE(dut->emit_o);
    dut->full_i = 0;
    dut->empty_i = 1;
    dut.tick();
    dut.settle();
    EXPECT_TRUE(dut->emit_o) << "one lane still holds hits";
    dut->empty_i = 3;
    dut.tick();
    dut.settle();
    EXPECT_TRUE(dut->fill_o);
    return tests;
  }

  Dut<Vbrute_walk> dut;
  Gate gate;
};

void expect_all_pairs(const std::vector<std::pair<int, int>>& tests, int used, int primitives) {
  ASSERT_EQ(tests.size(), static_cast<std::size_t>(used * primitives));
  for (int i = 0; i < used * primitives; ++i) EXPECT_EQ(tests[i], std::make_pair(i / used, i % used));
}

TEST(BruteWalk, MeetsEveryPairOnce) {
  for (const double stall : {0.0, 0.3, 0.6}) {
    Bench bench(stall);
    expect_all_pairs(bench.batch(32, 9), 32, 9);
    expect_all_pairs(bench.batch(1, 5), 1, 5);
    expect_all_pairs(bench.batch(7, 1), 7, 1);
    expect_all_pairs(bench.batch(64, 2), 64, 2);
  }
}

TEST(BruteWalk, ATestACycleWithoutStalls) {
  Bench bench(0);
  const long before = bench.dut.cycles();
  bench.batch(32, 100);
  EXPECT_LE(bench.dut.cycles() - before, 32 * 100 + 8);
}

TEST(BruteWalk, AnEmptyPrimitiveBufferEndsTheBatch) {
  Bench bench(0);
  expect_all_pairs(bench.batch(4, 0), 4, 0);
}

TEST(BruteWalk, StartsAPartBatchWhenTheWalkWaitsForItsOwnHits) {
  Bench bench(0);
  bench.dut->used_i = 3;
  bench.dut->empty_i = 0;
  bench.dut->starved_i = 1;
  bench.dut.settle();
  EXPECT_TRUE(bench.dut->reader_start_o);
  bench.dut->empty_i = 3;
  bench.dut.settle();
  EXPECT_FALSE(bench.dut->reader_start_o) << "there is no ray to trace";
  EXPECT_FALSE(bench.dut->idle_o) << "the walk goes on later";
}

TEST(BruteWalk, StartsAPartBatchOnlyWhenTheSourceIsExhausted) {
  Bench bench(0);
  bench.dut->used_i = 3;
  bench.dut->full_i = 1;
  bench.dut->empty_i = 0;
  for (int i = 0; i < 50; ++i) {
    bench.dut.settle();
    ASSERT_FALSE(bench.dut->reader_start_o);
    bench.dut.tick();
  }
  bench.dut->exhausted_i = 1;
  bench.dut.settle();
  EXPECT_TRUE(bench.dut->reader_start_o);
  EXPECT_FALSE(bench.dut->idle_o);
  bench.dut->empty_i = 3;
  bench.dut.settle();
  EXPECT_FALSE(bench.dut->reader_start_o);
  EXPECT_TRUE(bench.dut->idle_o);
}

}  // namespace
}  // namespace castray::tb
