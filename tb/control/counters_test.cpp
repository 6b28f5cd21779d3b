// SPDX-License-Identifier: Apache-2.0
// The counters: every event of every bit once, in the register of its name.
// Verilator: -GCountW=11
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
    for (int i = 0; i < 3; ++i) dut_.tick();   // the third: a count is shown the cycle behind its turn
  }
  // All counts, each in its turn.
  std::vector<std::uint64_t> counts() {
    std::vector<std::uint64_t> read(Counters);
    for (int i = 0; i < Counters; ++i) {
      read[dut_->number_o] = dut_->count_o;
      dut_.tick();
    }
    return read;
  }
  static constexpr std::uint64_t kMask = (1 << 11) - 1;
  Dut<Vcounters> dut_;
};

TEST_F(CountersTest, EachCountsItsOwnEvent) {
  settle();
  for (int at = 0; at < Counters; ++at) {
    for (unsigned lanes = 1; lanes < 256; lanes = lanes * 3 + 1) {
      std::vector<std::uint64_t> wanted = counts();
      drive([&](int counter) { return counter == at ? lanes : 0u; });
      dut_.tick();
      settle();
      wanted[at] = (wanted[at] + static_cast<unsigned>(__builtin_popcount(lanes))) & kMask;
      EXPECT_EQ(counts(), wanted) << at;
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
  const std::vector<std::uint64_t> read = counts();
  for (int i = 0; i < Counters; ++i) EXPECT_EQ(read[i], sum[i] & kMask) << i;
}

// The most events that there can be: the low bits carry once in each round, whoever's turn it is.
TEST_F(CountersTest, CarryInAnyCycleOfTheRound) {
  for (int start = 0; start < 2 * Counters; ++start) {
    dut_->clear_i = 1;
    dut_.tick();
    dut_->clear_i = 0;
    for (int i = 0; i < start; ++i) dut_.tick();
    for (unsigned cycle = 1; cycle <= 100; ++cycle) {
      drive([](int) { return 255u; });
      dut_.tick();
    }
    settle();
    EXPECT_EQ(counts(), std::vector<std::uint64_t>(Counters, 800));
  }
}

TEST_F(CountersTest, ClearAlsoDropsWhatIsOnItsWay) {
  drive([](int) { return 255u; });
  dut_.tick();
  dut_.tick();
  dut_->clear_i = 1;
  dut_.tick();
  settle();
  EXPECT_EQ(counts(), std::vector<std::uint64_t>(Counters));
  EXPECT_EQ(counts(), std::vector<std::uint64_t>(Counters));
}

}  // namespace castray::tb
