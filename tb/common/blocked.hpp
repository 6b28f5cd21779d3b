// SPDX-License-Identifier: Apache-2.0
// A pipe behind a shut sink: it takes an item a cycle until every stage is full, shows the first when it
// has come through, and gives them all, in order and one a cycle, when the sink opens.
#pragma once
#include "dut.hpp"

namespace castray::tb {

// item(i) is the i-th input, result(i) what must come of it. A stage is a register of an item, so the
// latency is as many cycles as there are stages.
template <class Out, class V, class Item, class Result>
void fill_and_drain(Dut<V>& dut, int stages, Item&& item, Result&& result) {
  dut->out_ready_i = 0;
  dut->in_valid_i = 1;
  int taken = 0;
  for (int cycle = 0; cycle < stages + 30; ++cycle) {
    set_port(dut->in_i, item(taken));
    dut.settle();
    EXPECT_EQ(dut->in_ready_o, taken < stages) << "cycle " << cycle;
    EXPECT_EQ(dut->out_valid_o, cycle >= stages) << "latency, cycle " << cycle;
    taken += dut->in_ready_o;
    dut.tick();
  }
  EXPECT_EQ(taken, stages);
  dut->in_valid_i = 0;
  dut->out_ready_i = 1;
  for (int i = 0; i < taken; ++i) {
    dut.settle();
    ASSERT_TRUE(dut->out_valid_o) << i << " of " << taken;
    EXPECT_TRUE(get_port<Out>(dut->out_o) == result(i)) << "item " << i;
    dut.tick();
  }
  dut.settle();
  EXPECT_FALSE(dut->out_valid_o);
}

}  // namespace castray::tb
