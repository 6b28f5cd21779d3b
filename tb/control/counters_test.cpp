// SPDX-License-Identifier: Apache-2.0
// The counters: every event of every lane once, in the register of its name.
// Verilator: -GLanes=8 -GCountW=8
#include "Vcounters.h"
#include "dut.hpp"

namespace castray::tb {

class CountersTest : public testing::Test {
 protected:
  CountersTest() { quiet(); }
  void quiet() { drive([](int) { return 0u; }), dut_->clear_i = 0; }

  // Sets each counter's events: value(counter) is a set of lanes, or a bit.
  template <class F> void drive(F&& value) {
    dut_->running_i = value(CntCycles) & 1;
    dut_->test_i = value(CntTests);
    dut_->ray_i = value(CntRays);
    dut_->hit_i = value(CntHits);
    dut_->candidate_i = value(CntCandidates);
    dut_->batch_i = value(CntBatches) & 1;
    dut_->test_stall_i = value(CntTestStalls) & 1;
    dut_->fetch_stall_i = value(CntFetchStalls) & 1;
    dut_->attr_hit_i = value(CntAttrHits) & 1;
    dut_->attr_miss_i = value(CntAttrMisses) & 1;
    dut_->read_beat_i = value(CntReadBeats) & 1;
    dut_->write_beat_i = value(CntWriteBeats) & 1;
  }
  static bool by_lane(int counter) {
    return counter == CntTests || counter == CntRays || counter == CntHits || counter == CntCandidates;
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
      drive([&](int counter) { return counter == at ? (by_lane(at) ? lanes : 1u) : 0u; });
      dut_.tick();
      settle();
      const unsigned step = by_lane(at) ? __builtin_popcount(lanes) : 1;
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
      events[i] = by_lane(i) ? rng() & 255 : rng() & 1;
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
