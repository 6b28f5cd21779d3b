// SPDX-License-Identifier: Apache-2.0
// The queue in block RAM: nothing lost, changed or invented; order kept; full after Depth items and one.
// Depth 5: not a power of two, so that its pointers have to wrap by themselves.
// Verilator: -GDepth=5
#include "Vblock_fifo.h"
#include "stream_link.hpp"

namespace castray::tb {
namespace {

using BlockFifo = StreamLink<Vblock_fifo>;
INSTANTIATE_TEST_SUITE_P(Stalls, BlockFifo, ::testing::ValuesIn(kStallPatterns));

TEST_P(BlockFifo, KeepsItemsInOrder) { keeps_items_in_order(GetParam(), 10000); }

TEST_F(BlockFifo, HoldsDepthItemsAndOneWhileBlocked) {
  EXPECT_EQ(taken_while_blocked(), 6);
  for (int i = 0; i < 6; ++i) {
    cycle(-1, true);
    EXPECT_EQ(given, 500 + i);
  }
  EXPECT_FALSE(dut->valid_o);
}

TEST_F(BlockFifo, PassesOneItemACycle) { EXPECT_EQ(passed_in(50), 48); }

TEST_F(BlockFifo, AnItemIsVisibleTwoCyclesAfterItEntered) {
  EXPECT_TRUE(dut->empty_o);
  EXPECT_TRUE(cycle(7, false));
  EXPECT_FALSE(dut->valid_o);
  EXPECT_FALSE(dut->empty_o);
  cycle(-1, false);
  EXPECT_TRUE(dut->valid_o);
  cycle(-1, true);
  EXPECT_EQ(given, 7);
  EXPECT_FALSE(dut->valid_o);
  EXPECT_TRUE(dut->empty_o);
}

TEST_F(BlockFifo, RefusesWhenFullThoughOneLeaves) {
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(cycle(i, false));
  EXPECT_FALSE(cycle(6, true)) << "ready does not depend on ready_i";
  EXPECT_EQ(given, 0);
  EXPECT_TRUE(cycle(6, false));
}

TEST_F(BlockFifo, ForgetsItsItemsInReset) {
  for (int i = 0; i < 3; ++i) cycle(i, false);
  dut->valid_i = 0;
  dut.reset();
  EXPECT_FALSE(dut->valid_o);
  EXPECT_TRUE(cycle(9, true));
  for (int i = 0; i < 3; ++i) cycle(-1, i == 2);
  EXPECT_EQ(given, 9);
}

}  // namespace
}  // namespace castray::tb
