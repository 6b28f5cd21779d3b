// SPDX-License-Identifier: Apache-2.0
// Two inputs, one output: nothing lost, changed or invented; each input's order kept; both served.
// Verilator: -GDepth=5
#include "Vpair_fifo.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

class PairFifo : public testing::TestWithParam<Stalls> {
 protected:
  PairFifo() { dut->valid_i = dut->ready_i = 0; }
  Dut<Vpair_fifo> dut;
};
INSTANTIATE_TEST_SUITE_P(Patterns, PairFifo, testing::ValuesIn(kStallPatterns));

TEST_P(PairFifo, KeepsItemsInTheOrderOfEachInput) {
  const Stalls stalls = GetParam();
  Gate source[] = {{stalls.source, stalls.burst, 1}, {stalls.source, stalls.burst, 2}}, sink(stalls.sink, stalls.burst, 3);
  std::uint32_t sent[2] = {}, given[2] = {};
  bool offering[2] = {}, held = false;
  std::uint32_t held_item = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    dut->valid_i = 0;
    for (std::uint32_t i = 0; i < 2; ++i) {
      offering[i] = offering[i] || source[i].open();
      dut->valid_i |= offering[i] << i;
      dut->data_i[i] = sent[i] * 2 + i;
    }
    dut->ready_i = sink.open();
    dut.settle();
    if (dut->valid_o) {
      const std::uint32_t item = dut->data_o, from = item % 2;
      if (held) ASSERT_EQ(item, held_item) << "an untaken item changed";
      ASSERT_EQ(item / 2, given[from]);
      held = !dut->ready_i, held_item = item;
      given[from] += dut->ready_i;
    }
    for (int i = 0; i < 2; ++i)
      if (offering[i] && dut->ready_o >> i & 1) ++sent[i], offering[i] = false;
    dut.tick();
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(given[i], 2500u);
    EXPECT_LE(sent[i] - given[i], 5u);
  }
}

TEST_F(PairFifo, HoldsDepthItemsOfEachInputWhileBlocked) {
  dut->valid_i = 3;
  int taken[2] = {};
  for (int cycle = 0; cycle < 20; ++cycle) {
    dut.settle();
    for (int i = 0; i < 2; ++i) taken[i] += dut->ready_o >> i & 1;
    dut.tick();
  }
  EXPECT_EQ(taken[0], 5);
  EXPECT_EQ(taken[1], 5);
}

}  // namespace
}  // namespace castray::tb
