// SPDX-License-Identifier: Apache-2.0
// The queue: nothing lost, nothing changed, order kept, full after exactly Depth items.
// Verilator: -GDepth=5
#include "Vstream_fifo.h"
#include "dut.hpp"

namespace castray::tb {

TEST(StreamFifo, HoldsDepthItemsWhileBlocked) {
  Dut<Vstream_fifo> dut;
  dut->ready_i = 0;
  int taken = 0;
  for (int i = 0; i < 20; ++i) {
    dut->valid_i = 1;
    dut->data_i = 100 + taken;
    dut.settle();
    EXPECT_EQ(dut->used_o, taken);
    taken += dut->ready_o;
    dut.tick();
  }
  EXPECT_EQ(taken, 5);
  dut->valid_i = 0;
  dut->ready_i = 1;
  for (int i = 0; i < 5; ++i) {
    dut.settle();
    ASSERT_TRUE(dut->valid_o);
    EXPECT_EQ(dut->data_o, 100u + i);
    dut.tick();
  }
  dut.settle();
  EXPECT_FALSE(dut->valid_o);
}

}  // namespace castray::tb
