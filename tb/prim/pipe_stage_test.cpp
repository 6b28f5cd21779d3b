// SPDX-License-Identifier: Apache-2.0
// The register of a stream: nothing lost, changed or invented; one place, one item a cycle.
#include "Vpipe_stage.h"
#include "stream_link.hpp"

namespace castray::tb {
namespace {

using PipeStage = StreamLink<Vpipe_stage>;
INSTANTIATE_TEST_SUITE_P(Stalls, PipeStage, ::testing::ValuesIn(kStallPatterns));

TEST_P(PipeStage, KeepsItemsInOrder) { keeps_items_in_order(GetParam(), 10000); }

TEST_F(PipeStage, HoldsOneItemWhileBlocked) {
  EXPECT_EQ(taken_while_blocked(), 1);
  EXPECT_TRUE(dut->valid_o);
  EXPECT_EQ(dut->data_o, 500u);
}

TEST_F(PipeStage, PassesOneItemACycle) { EXPECT_EQ(passed_in(50), 49); }

TEST_F(PipeStage, TakesAnItemAsItsOwnLeaves) {
  cycle(1, false);
  EXPECT_FALSE(cycle(2, false));
  EXPECT_TRUE(cycle(2, true));
  EXPECT_EQ(given, 1);
  cycle(-1, true);
  EXPECT_EQ(given, 2);
}

TEST_F(PipeStage, ForgetsItsItemInReset) {
  cycle(7, false);
  EXPECT_TRUE(dut->valid_o);
  dut->valid_i = 0;
  dut.reset();
  EXPECT_FALSE(dut->valid_o);
}

}  // namespace
}  // namespace castray::tb
