// SPDX-License-Identifier: Apache-2.0
// Which clocks run: all in reset and in the hierarchy; by brute force that of the caches never, the other two in
// the cycles in which an item passes on one of their streams, and Settle more.
#include "Vclock_wake.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kStreams = 3, kSettle = 5;   // clock_wake_tb

TEST(ClockWake, WhatPassesWakesItsUnit) {
  Dut<Vclock_wake> dut;
  std::mt19937 rng(8);
  unsigned edges[3], left[3] = {0, kSettle, kSettle};
  dut->rst_ni = 0;
  dut->brute_i = 1;
  dut.tick();
  for (int i = 0; i < 3; ++i) edges[i] = dut->edges_o[i];
  for (int cycle = 0; cycle < 50000; ++cycle) {
    const auto bits = [&] { return rng() % 4 ? 0u : static_cast<unsigned>(rng() % (1 << kStreams)); };
    const bool reset = rng() % 50 == 0;
    if (rng() % 200 == 0) dut->brute_i = rng() % 4 != 0;
    dut->rst_ni = !reset;
    dut->camera_valid_i = bits(), dut->camera_ready_i = bits();
    dut->shading_valid_i = bits(), dut->shading_ready_i = bits();
    const bool all = reset || !dut->brute_i;
    const bool awake[3] = {all, all || (dut->camera_valid_i & dut->camera_ready_i), all || (dut->shading_valid_i & dut->shading_ready_i)};
    for (int i = 0; i < 3; ++i) {
      edges[i] += awake[i] || left[i] > 0;
      left[i] = i == 0 ? 0 : awake[i] ? kSettle : left[i] - (left[i] > 0);
    }
    dut.tick();
    for (int i = 0; i < 3; ++i) ASSERT_EQ(dut->edges_o[i], edges[i]) << "clock " << i << ", cycle " << cycle;
  }
}

}  // namespace
}  // namespace castray::tb
