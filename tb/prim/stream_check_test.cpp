// SPDX-License-Identifier: Apache-2.0
// The checker: silent while a stream keeps its contract, fatal where it drops or changes an item.
#include "Vstream_check.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

struct Cycle {
  int valid, ready, data;
};

void play(const std::vector<Cycle>& cycles) {
  Dut<Vstream_check> dut;
  for (const Cycle& cycle : cycles) {
    dut->valid_i = cycle.valid;
    dut->ready_i = cycle.ready;
    dut->data_i = cycle.data;
    dut.tick();
  }
}

TEST(StreamCheck, AllowsWhatTheContractAllows) {
  play({{0, 0, 1}, {0, 1, 0}, {1, 1, 1}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 0, 0}});
}

TEST(StreamCheckDeathTest, CatchesADroppedItem) { EXPECT_DEATH(play({{1, 0, 1}, {0, 0, 1}, {0, 0, 1}}), ""); }

TEST(StreamCheckDeathTest, CatchesAChangedItem) { EXPECT_DEATH(play({{1, 0, 1}, {1, 0, 0}, {1, 1, 0}}), ""); }

TEST(StreamCheckDeathTest, CatchesAnItemThatChangesAsItIsTaken) { EXPECT_DEATH(play({{1, 0, 1}, {1, 1, 0}, {0, 0, 0}}), ""); }

TEST(StreamCheck, IsSilentInReset) {
  Dut<Vstream_check> dut;
  dut->valid_i = 1;
  dut->ready_i = 0;
  dut->data_i = 0;
  dut.tick();
  dut->valid_i = 0;
  dut.reset();
  dut.tick();
}

}  // namespace
}  // namespace castray::tb
