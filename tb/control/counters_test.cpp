// SPDX-License-Identifier: Apache-2.0
// The counters: every event of every bit once, in the register of its name.
// Verilator: -GCountW=8
#include "Vcounters.h"
#include "dut.hpp"

namespace castray::tb {

class CountersTest : public testing::Test {
 protected:
  CountersTest() { quiet(); }
  void quiet() { drive([](int) { return 0u; }), dut_->clear_i = 0; }

  // Sets each counter's events: value(counter) has a bit for each.
  template <class F> void drive(F&& value) {
    for (int i = 0; i < Counters; ++i) dut_->events_i[i] = static_cast<std::uint8_t>(value(i));
  }
  void settle() {
    quiet();
    dut_.tick();
    dut_.tick();
  }
  Dut<Vcounters> dut_;
};

TEST_F(CountersTest, EachCountsItsOwnEvent) {
  settle();
  for (int at = 0; at < Counters; ++at) {
    for (unsigned lanes = 1; lanes < 256; lanes = lanes * 3 + 1) {
      const std::uint64_t before = dut_->counts_o[at];
      std::vector<std::uint64_t> others(std::begin(dut_->counts_o), std::end(dut_->counts_o));
      drive([&](int counter) { return counter == at ? lanes : 0u; });
      dut_.tick();
      settle();
      const unsigned step = __builtin_popcount(lanes);
      EXPECT_EQ(dut_->counts_o[at], (before + step) & 255) << at;
      for (int i = 0; i < Counters; ++i)
        if (i != at) EXPECT_EQ(dut_->counts_o[i], others[i]) << i;
    }
  }
}

TEST_F(CountersTest, AllCountEveryCycle) {
  std::mt19937 rng(2);
  dut_->clear_i = 1;
  dut_.tick();
  dut_->clear_i = 0;
  std::vector<unsigned> sum(Counters);
  for (int cycle = 0; cycle < 3000; ++cycle) {
    std::vector<unsigned> events(Counters);
    for (int i = 0; i < Counters; ++i) {
      events[i] = rng() & 255;
      sum[i] += __builtin_popcount(events[i]);
    }
    drive([&](int counter) { return events[counter]; });
    dut_.tick();
  }
  settle();
  for (int i = 0; i < Counters; ++i) EXPECT_EQ(dut_->counts_o[i], sum[i] & 255) << i;
}

TEST_F(CountersTest, ClearAlsoDropsWhatIsOnItsWay) {
  drive([](int) { return 255u; });
  dut_.tick();
  dut_.tick();
  dut_->clear_i = 1;
  dut_.tick();
  settle();
  for (int i = 0; i < Counters; ++i) EXPECT_EQ(dut_->counts_o[i], 0u) << i;
}

}  // namespace castray::tb
