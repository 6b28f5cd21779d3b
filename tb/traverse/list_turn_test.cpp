// SPDX-License-Identifier: Apache-2.0
// Runs of 16 rays to three lanes in turn, counted by rays that are taken.
// Verilator: -GLanes=3
#include "Vlist_turn.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

TEST(ListTurn, DealsRunsInTurn) {
  Dut<Vlist_turn> dut;
  std::mt19937 rng(1);
  int taken = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    dut->taken_i = rng() % 3 != 0;
    dut.settle();
    ASSERT_EQ(dut->lane_o, taken / 16 % 3) << taken;
    taken += dut->taken_i;
    dut.tick();
  }
}

TEST(ListTurn, BeginsAnewAfterAReset) {
  Dut<Vlist_turn> dut;
  dut->taken_i = 1;
  for (int i = 0; i < 20; ++i) dut.tick();
  dut.settle();
  EXPECT_EQ(dut->lane_o, 1);
  dut.reset();
  for (int i = 0; i < 16; ++i, dut.tick()) EXPECT_EQ(dut->lane_o, 0) << i;
  EXPECT_EQ(dut->lane_o, 1);
}

}  // namespace
}  // namespace castray::tb
