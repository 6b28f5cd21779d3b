// SPDX-License-Identifier: Apache-2.0
// A gated clock: an edge in each cycle that is awake and in Settle more, in no other, and none between.
#include "Vclock_gate.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kSettle = 3;  // clock_gate_tb
constexpr int kThrough = 0, kGated = 1, kSettling = 2;

TEST(ClockGate, RunsWhileAwakeAndSettling) {
  Dut<Vclock_gate> dut;
  std::mt19937 rng(5);
  dut->awake_i = 0;
  for (unsigned i = 0; i <= kSettle; ++i) dut.tick();  // what was left of the time before is over
  unsigned edges[3], left = 0;
  for (int gate : {kThrough, kGated, kSettling}) edges[gate] = dut->edges_o[gate];
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const bool awake = rng() % 8 == 0;
    dut->awake_i = awake;
    edges[kThrough] += 1;
    edges[kGated] += awake;
    edges[kSettling] += awake || left > 0;
    left = awake ? kSettle : left - (left > 0);
    dut.tick();
    for (int gate : {kThrough, kGated, kSettling}) ASSERT_EQ(dut->edges_o[gate], edges[gate]) << "gate " << gate << ", cycle " << cycle;
  }
}

TEST(ClockGate, WakingWhileTheClockIsHighMakesNoEdge) {
  Dut<Vclock_gate> dut;
  dut->awake_i = 0;
  for (unsigned i = 0; i <= kSettle; ++i) dut.tick();
  dut.settle();
  const unsigned gated = dut->edges_o[kGated];
  dut->clk_i = 1;
  dut.settle();
  dut->awake_i = 1;
  dut.settle();
  EXPECT_EQ(dut->edges_o[kGated], gated);
  dut->awake_i = 0;
  dut.settle();
  dut->clk_i = 0;
  dut.settle();
  EXPECT_EQ(dut->edges_o[kGated], gated);
}

}  // namespace
}  // namespace castray::tb
