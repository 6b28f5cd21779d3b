// SPDX-License-Identifier: Apache-2.0
// Every number is out once at most, and all of them can be out.
// Verilator: -GN=5
#include <deque>
#include <set>

#include "Vfree_list.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kNumbers = 5;

TEST(FreeList, HandsOutEachNumberOnceAndThoseGivenBackInOrder) {
  Dut<Vfree_list> dut;
  std::mt19937 rng(3);
  std::set<unsigned> out;
  std::deque<unsigned> back;
  unsigned fresh = 0;
  long taken = 0, all_out = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const bool give = !out.empty() && rng() % 8 < (cycle / 100 % 2 ? 2u : 6u);
    dut->give_i = give;
    if (give) {
      auto number = out.begin();
      std::advance(number, static_cast<long>(rng() % out.size()));
      dut->number_i = static_cast<std::uint8_t>(*number);
    }
    dut.settle();
    const bool free = fresh < kNumbers || !back.empty();
    ASSERT_EQ(dut->valid_o, free);
    if (free) ASSERT_EQ(dut->number_o, fresh < kNumbers ? fresh : back.front());
    dut->take_i = free && rng() % 2;
    dut.settle();
    if (dut->take_i) {
      ASSERT_TRUE(out.insert(dut->number_o).second) << "a number is out twice";
      fresh < kNumbers ? void(++fresh) : back.pop_front();
      ++taken;
    }
    if (give) {
      out.erase(dut->number_i);
      back.push_back(dut->number_i);
    }
    all_out += out.size() == kNumbers;
    dut.tick();
  }
  EXPECT_GT(taken, 3000);
  EXPECT_GT(all_out, 100);
}

TEST(FreeList, HasAllNumbersAfterAReset) {
  Dut<Vfree_list> dut;
  for (int out = 0; out <= static_cast<int>(kNumbers); ++out) {
    dut->give_i = 0;
    for (int i = 0; i < out; ++i) {
      dut->take_i = 1;
      dut.settle();
      EXPECT_TRUE(dut->valid_o);
      EXPECT_EQ(dut->number_o, i);
      dut.tick();
    }
    dut->take_i = 0;
    dut.reset();
  }
}

}  // namespace
}  // namespace castray::tb
