// SPDX-License-Identifier: Apache-2.0
// pipe_chain: payloads moved by its load strobes arrive once, in order; bubbles close up.
// Verilator: -GStages=3
#include "Vpipe_chain.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kStages = 3;

class PipeChain : public ::testing::TestWithParam<Stalls> {
 protected:
  // One cycle of the payloads: those whose load is raised take the one before them.
  void tick(int offered) {
    dut.settle();
    const unsigned load = dut->load_o;
    for (int i = kStages - 1; i >= 0; --i)
      if (load >> i & 1) stage_[i] = i ? stage_[i - 1] : offered;
    dut.tick();
  }
  Dut<Vpipe_chain> dut;
  int stage_[kStages] = {};
};
INSTANTIATE_TEST_SUITE_P(Stalls, PipeChain, ::testing::ValuesIn(kStallPatterns));

TEST_P(PipeChain, KeepsOrder) {
  Gate source(GetParam().source, GetParam().burst, 1), sink(GetParam().sink, GetParam().burst, 2);
  int sent = 0, received = 0;
  bool offering = false;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    offering = offering || source.open();
    dut->valid_i = offering;
    dut->ready_i = sink.open();
    dut.settle();
    const bool taken = offering && dut->ready_o;
    EXPECT_EQ(dut->load_o & 1, taken);
    if (dut->valid_o) {
      ASSERT_EQ(stage_[kStages - 1], received);
      received += dut->ready_i;
    }
    tick(sent);
    sent += taken;
    offering = offering && !taken;
  }
  EXPECT_GT(received, 5000);
  EXPECT_LE(sent - received, kStages);
}

TEST_F(PipeChain, FillsEveryStageWhileBlocked) {
  int taken = 0;
  dut->ready_i = 0;
  for (int cycle = 0; cycle < 30; ++cycle) {
    dut->valid_i = cycle % 2;
    dut.settle();
    taken += dut->valid_i && dut->ready_o;
    tick(cycle);
  }
  EXPECT_EQ(taken, kStages);
  EXPECT_EQ(dut->load_o, 0);
  dut->ready_i = 1;
  dut->valid_i = 1;
  dut.settle();
  EXPECT_EQ(dut->load_o, 7) << "all move when the last one is taken";
}

TEST_F(PipeChain, LoadsNothingWhenEmpty) {
  dut->valid_i = 0;
  dut->ready_i = 1;
  dut.settle();
  EXPECT_EQ(dut->load_o, 0);
  EXPECT_TRUE(dut->ready_o);
  dut->valid_i = 1;
  dut.settle();
  EXPECT_EQ(dut->load_o, 1);
  dut.tick();
  dut->valid_i = 0;
  for (const int load : {2, 4, 0}) {
    dut.settle();
    EXPECT_EQ(dut->load_o, load);
    EXPECT_EQ(dut->valid_o, load == 0);
    dut.tick();
  }
  EXPECT_FALSE(dut->valid_o) << "taken";
}

}  // namespace
}  // namespace castray::tb
