// SPDX-License-Identifier: Apache-2.0
// The fork: every output takes every item exactly once, whatever the order in which they are ready.
// Verilator: -GN=3
#include "Vstream_fork.h"
#include "dut.hpp"

namespace castray::tb {

TEST(StreamFork, EveryOutputTakesEveryItemOnce) {
  Dut<Vstream_fork> dut;
  std::mt19937 rng(5);
  int items = 0;
  int taken[3] = {};
  bool offered = false;
  for (int cycle = 0; cycle < 50000; ++cycle) {
    offered = offered || rng() % 3 != 0;
    dut->valid_i = offered;
    dut->ready_i = rng() & rng() & 7;
    dut.settle();
    const int takes = dut->valid_o & dut->ready_i;
    for (int i = 0; i < 3; ++i) taken[i] += (takes >> i) & 1;
    for (int i = 0; i < 3; ++i) ASSERT_LE(taken[i], items + 1) << "output " << i << " took an item twice";
    if (offered && dut->ready_o) {
      ++items;
      for (int i = 0; i < 3; ++i) ASSERT_EQ(taken[i], items) << "output " << i;
      offered = false;
    }
    dut.tick();
  }
  EXPECT_GT(items, 5000);
}

TEST(StreamFork, PassesAnItemInOneCycleWhenAllAreReady) {
  Dut<Vstream_fork> dut;
  dut->valid_i = 1;
  dut->ready_i = 7;
  for (int i = 0; i < 8; ++i) {
    dut.settle();
    EXPECT_TRUE(dut->ready_o);
    EXPECT_EQ(dut->valid_o, 7);
    dut.tick();
  }
}

}  // namespace castray::tb
