// SPDX-License-Identifier: Apache-2.0
// Credits: exactly Limit may be inside, and the count survives takes and gives in one cycle.
// Verilator: -GLimit=6 -GGives=2
#include "Vcredit.h"
#include "dut.hpp"

namespace castray::tb {

TEST(Credit, GivesOutExactlyLimit) {
  Dut<Vcredit> dut;
  dut->give_i = 0;
  int taken = 0;
  for (int i = 0; i < 10; ++i) {
    dut.settle();
    dut->take_i = dut->available_o;
    taken += dut->available_o;
    dut.tick();
  }
  dut->take_i = 0;
  EXPECT_EQ(taken, 6);
  EXPECT_FALSE(dut->idle_o);
}

TEST(Credit, CountsTakesAndBothGivesOfOneCycle) {
  Dut<Vcredit> dut;
  std::mt19937 rng(3);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    dut->take_i = 0;
    dut->give_i = 0;
    dut.settle();
    ASSERT_EQ(dut->available_o, inside < 6) << "cycle " << i;
    ASSERT_EQ(dut->idle_o, inside == 0) << "cycle " << i;
    const bool take = dut->available_o && rng() % 2;
    const int give = std::min<int>(inside, rng() % 3);
    dut->take_i = take;
    dut->give_i = give == 0 ? 0 : give == 2 ? 3 : 1 + rng() % 2;
    inside += take - give;
    dut.tick();
  }
}

void play(int takes, int gives) {
  Dut<Vcredit> dut;
  dut->give_i = 0;
  dut->take_i = 1;
  for (int i = 0; i < takes; ++i) dut.tick();
  dut->take_i = 0;
  dut->give_i = 1;
  for (int i = 0; i < gives; ++i) dut.tick();
  dut->give_i = 0;
  dut.tick();
}
TEST(Credit, AllowsLimitInside) { play(6, 6); }
TEST(CreditDeathTest, CatchesOneMoreThanLimit) { EXPECT_DEATH(play(7, 0), ""); }
TEST(CreditDeathTest, CatchesOneGivenThatWasNotTaken) { EXPECT_DEATH(play(1, 2), ""); }

}  // namespace castray::tb
