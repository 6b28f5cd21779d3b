// SPDX-License-Identifier: Apache-2.0
// The queue: nothing lost, changed or invented; order kept; full after exactly Depth items.
// Depth 5: not a power of two, so that its pointers have to wrap by themselves.
// Verilator: -GDepth=5
#include "Vstream_fifo.h"
#include "stream_link.hpp"

namespace castray::tb {
namespace {

using StreamFifo = StreamLink<Vstream_fifo>;
INSTANTIATE_TEST_SUITE_P(Stalls, StreamFifo, ::testing::ValuesIn(kStallPatterns));

TEST_P(StreamFifo, KeepsItemsInOrder) { keeps_items_in_order(GetParam(), 10000); }

TEST_F(StreamFifo, HoldsDepthItemsWhileBlocked) {
  EXPECT_EQ(taken_while_blocked(), 5);
  for (int i = 0; i < 5; ++i) {
    cycle(-1, true);
    EXPECT_EQ(given, 500 + i);
  }
  EXPECT_FALSE(dut->valid_o);
}

TEST_F(StreamFifo, PassesOneItemACycle) { EXPECT_EQ(passed_in(50), 49); }

TEST_F(StreamFifo, CountsItsItems) {
  std::mt19937 rng(1);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    ASSERT_EQ(dut->used_o, inside);
    ASSERT_EQ(dut->ready_o, inside < 5);
    ASSERT_EQ(dut->valid_o, inside > 0);
    const bool push_more = (i / 100) % 2;
    inside += cycle(rng() % 3 < (push_more ? 2 : 1) ? i : -1, rng() % 3 < (push_more ? 1 : 2));
    inside -= given >= 0;
  }
}

TEST_F(StreamFifo, RefusesWhenFullThoughOneLeaves) {
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(cycle(i, false));
  EXPECT_FALSE(cycle(5, true)) << "ready does not depend on ready_i";
  EXPECT_EQ(given, 0);
  EXPECT_TRUE(cycle(5, false));
}

TEST_F(StreamFifo, ForgetsItsItemsInReset) {
  for (int i = 0; i < 3; ++i) cycle(i, false);
  dut->valid_i = 0;
  dut.reset();
  EXPECT_FALSE(dut->valid_o);
  EXPECT_EQ(dut->used_o, 0);
}

}  // namespace
}  // namespace castray::tb
