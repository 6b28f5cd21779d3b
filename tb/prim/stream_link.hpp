// SPDX-License-Identifier: Apache-2.0
// What pipe_stage, pipe_cut and stream_fifo have in common: one stream of 32-bit items in, one out.
#pragma once
#include "dut.hpp"

namespace castray::tb {

template <class V> class StreamLink : public ::testing::TestWithParam<Stalls> {
 protected:
  // One cycle: offers `item`, or nothing if it is negative; true if it was taken.
  bool cycle(long item, bool ready) {
    dut->valid_i = item >= 0;
    dut->data_i = item >= 0 ? static_cast<unsigned>(item) : 0xdead;
    dut->ready_i = ready;
    dut.settle();
    given = dut->valid_o && ready ? static_cast<long>(dut->data_o) : -1;
    const bool taken = item >= 0 && dut->ready_o;
    dut.tick();
    return taken;
  }

  // Nothing lost, changed, doubled or invented; order kept. Numbered items, hashed.
  void keeps_items_in_order(Stalls stalls, int count) {
    const auto item = [](long i) { return static_cast<long>(static_cast<std::uint32_t>(i * 2654435761u)); };
    Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2);
    long sent = 0, got = 0, held = -1;
    bool offering = false;
    for (int i = 0; i < 20 * count && got < count; ++i) {
      offering = offering || (sent < count && source.open());
      const bool ready = sink.open();
      if (held >= 0) {
        dut.settle();
        ASSERT_TRUE(dut->valid_o) << "an untaken item was dropped";
      }
      if (cycle(offering ? item(sent) : -1, ready)) {
        ++sent;
        offering = false;
      }
      if (given >= 0) ASSERT_EQ(given, item(got++));
      held = dut->valid_o ? static_cast<long>(dut->data_o) : -1;
    }
    EXPECT_EQ(sent, count);
    EXPECT_EQ(got, count);
    for (int i = 0; i < 10; ++i) {
      cycle(-1, true);
      EXPECT_EQ(given, -1) << "an item that nobody sent";
    }
  }

  // Items taken while the sink is shut, though only every third cycle offers one.
  int taken_while_blocked() {
    int taken = 0;
    for (int i = 0; i < 60; ++i) taken += cycle(i % 3 ? -1 : 500 + taken, false);
    return taken;
  }

  // A full link: as many items a cycle as it can pass, from a source and a sink that never wait.
  int passed_in(int cycles) {
    int passed = 0;
    for (int i = 0; i < cycles; ++i) {
      cycle(i, true);
      passed += given >= 0;
    }
    return passed;
  }

  Dut<V> dut;
  long given = -1;  // the item that left in the last cycle; -1: none
};

}  // namespace castray::tb
