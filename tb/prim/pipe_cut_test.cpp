// SPDX-License-Identifier: Apache-2.0
// The register that cuts both paths: nothing lost, changed or invented; two places, one item a
// cycle; ready does not depend on ready_i nor valid on valid_i.
#include "Vpipe_cut.h"
#include "stream_link.hpp"

namespace castray::tb {
namespace {

using PipeCut = StreamLink<Vpipe_cut>;
INSTANTIATE_TEST_SUITE_P(Stalls, PipeCut, ::testing::ValuesIn(kStallPatterns));

TEST_P(PipeCut, KeepsItemsInOrder) { keeps_items_in_order(GetParam(), 10000); }

TEST_F(PipeCut, HoldsTwoItemsWhileBlocked) {
  EXPECT_EQ(taken_while_blocked(), 2);
  cycle(-1, true);
  EXPECT_EQ(given, 500);
  cycle(-1, true);
  EXPECT_EQ(given, 501);
  cycle(-1, true);
  EXPECT_EQ(given, -1);
}

TEST_F(PipeCut, PassesOneItemACycle) { EXPECT_EQ(passed_in(50), 49); }

TEST_F(PipeCut, RefusesForOneCycleAfterItFilled) {
  cycle(1, false);
  cycle(2, false);
  EXPECT_FALSE(cycle(3, true)) << "ready comes from a register";
  EXPECT_EQ(given, 1);
  EXPECT_TRUE(cycle(3, true));
  EXPECT_EQ(given, 2);
  cycle(-1, true);
  EXPECT_EQ(given, 3);
}

TEST_F(PipeCut, CutsBothPaths) {
  for (const int items : {0, 1, 2}) {
    dut->valid_i = 0;
    dut.reset();
    for (int i = 0; i < items; ++i) cycle(i, false);
    for (const int valid : {0, 1}) {
      for (const int ready : {0, 1}) {
        dut->valid_i = valid;
        dut->ready_i = ready;
        dut.settle();
        EXPECT_EQ(dut->ready_o, items < 2);
        EXPECT_EQ(dut->valid_o, items > 0);
      }
    }
  }
}

TEST_F(PipeCut, ForgetsItsItemsInReset) {
  cycle(7, false);
  cycle(8, false);
  dut->valid_i = 0;
  dut.reset();
  EXPECT_FALSE(dut->valid_o);
  EXPECT_TRUE(dut->ready_o);
}

}  // namespace
}  // namespace castray::tb
