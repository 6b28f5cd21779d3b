// SPDX-License-Identifier: Apache-2.0
// Dealing out rays: strictly in turn, each batch from the first lane on.
// Verilator: -GLanes=3
#include "Vray_dispatch.h"
#include "dut.hpp"

namespace castray::tb {

TEST(RayDispatch, DealsInTurnAndWaitsForItsLane) {
  Dut<Vray_dispatch> dut;
  dut->restart_i = 0;
  std::mt19937 rng(2);
  int next = 0;
  for (int i = 0; i < 10000; ++i) {
    dut->in_valid_i = rng() % 2;
    dut->out_ready_i = rng() % 8;
    dut.settle();
    ASSERT_EQ(dut->out_valid_o, dut->in_valid_i << next);
    ASSERT_EQ(dut->in_ready_o, (dut->out_ready_i >> next) & 1);
    const bool taken = dut->in_valid_i && dut->in_ready_o;
    dut.tick();
    if (taken) next = (next + 1) % 3;
  }
}

// A batch of four rays on three lanes leaves off in the middle: the next begins at lane 0 again.
TEST(RayDispatch, StartsEachBatchAtTheFirstLane) {
  Dut<Vray_dispatch> dut;
  dut->restart_i = 0;
  dut->in_valid_i = 1;
  dut->out_ready_i = 7;
  for (int i = 0; i < 4; ++i) dut.tick();
  dut->in_valid_i = 0;
  dut->restart_i = 1;
  dut.tick();
  dut->restart_i = 0;
  dut->in_valid_i = 1;
  dut.settle();
  EXPECT_EQ(dut->out_valid_o, 1);
}

}  // namespace castray::tb
