// SPDX-License-Identifier: Apache-2.0
// The arbiter: each input's items arrive once and in order; round robin; an offered item is kept
// though another input, whose turn is earlier, starts to offer.
#include "Vstream_arb.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kInputs = 4;

class StreamArb : public ::testing::TestWithParam<Stalls> {
 protected:
  // The inputs of `offered` offer their number in the upper bits and `items` in the lower ones.
  void drive(unsigned offered, bool ready) {
    dut->valid_i = offered;
    dut->ready_i = ready;
    std::uint64_t data = 0;
    for (int i = 0; i < kInputs; ++i) data |= std::uint64_t(i << 12 | (items[i] & 0xfff)) << (16 * i);
    dut->data_i = data;
    dut.settle();
  }
  // One cycle with a ready sink: the input that was served, -1 for none.
  int serve(unsigned offered) {
    drive(offered, true);
    const int served = dut->valid_o ? dut->index_o : -1;
    dut.tick();
    return served;
  }
  // After a reset the first turn is that of input 1.
  void start_again() {
    dut->valid_i = 0;
    dut.reset();
  }
  std::vector<int> serve_many(unsigned offered, int cycles) {
    std::vector<int> served(cycles);
    for (int& index : served) index = serve(offered);
    return served;
  }

  Dut<Vstream_arb> dut;
  int items[kInputs] = {};
};
INSTANTIATE_TEST_SUITE_P(Stalls, StreamArb, ::testing::ValuesIn(kStallPatterns));

TEST_P(StreamArb, EachInputsItemsArriveOnceInOrder) {
  const Stalls stalls = GetParam();
  std::deque<Gate> sources;
  for (int i = 0; i < kInputs; ++i) sources.emplace_back(stalls.source, stalls.burst, 10 + i);
  Gate sink(stalls.sink, stalls.burst, 3);
  unsigned offered = 0;
  int total = 0, held = -1;
  int waited[kInputs] = {};
  for (int cycle = 0; cycle < 40000; ++cycle) {
    for (int i = 0; i < kInputs; ++i)
      if (!(offered >> i & 1) && sources[i].open()) offered |= 1u << i;
    const bool ready = sink.open();
    drive(offered, ready);
    ASSERT_EQ(dut->valid_o, offered != 0);
    if (dut->valid_o) {
      const int index = dut->index_o;
      ASSERT_TRUE(offered >> index & 1) << "an item of an input that offers none";
      ASSERT_EQ(dut->data_o, (index << 12 | (items[index] & 0xfff)));
      if (held >= 0) ASSERT_EQ(index, held) << "an offered item was exchanged";
      ASSERT_EQ(dut->ready_o & offered, ready ? 1u << index : 0u) << "exactly the offered item is taken";
      if (ready) {
        for (int i = 0; i < kInputs; ++i) waited[i] = i == index || !(offered >> i & 1) ? 0 : waited[i] + 1;
        for (const int turns : waited) ASSERT_LT(turns, kInputs) << "served less than once in N turns";
        ++items[index];
        ++total;
        offered &= ~(1u << index);
      }
      held = ready ? -1 : index;
    } else {
      ASSERT_EQ(held, -1) << "an offered item was dropped";
    }
    dut.tick();
  }
  EXPECT_GT(total, 10000);
  for (const int count : items) EXPECT_GT(count, total / 8) << "an input starves";
}

TEST_F(StreamArb, ServesAllInTurn) {
  EXPECT_EQ(serve_many(15, 8), (std::vector<int>{1, 2, 3, 0, 1, 2, 3, 0}));
  start_again();
  EXPECT_EQ(serve_many(5, 4), (std::vector<int>{2, 0, 2, 0})) << "inputs that offer nothing are passed over";
  start_again();
  EXPECT_EQ(serve_many(8, 3), (std::vector<int>{3, 3, 3})) << "a lone input is served every cycle";
  EXPECT_EQ(serve_many(0, 2), (std::vector<int>{-1, -1}));
  EXPECT_EQ(serve_many(9, 3), (std::vector<int>{0, 3, 0})) << "idle cycles do not change whose turn it is";
}

TEST_F(StreamArb, KeepsAnOfferedItem) {
  for (const unsigned offered : {8u, 10u, 15u}) {  // 1 and 2, whose turns are earlier, come later
    drive(offered, false);
    EXPECT_EQ(dut->index_o, 3);
    EXPECT_EQ(dut->ready_o & offered, 0);
    dut.tick();
  }
  EXPECT_EQ(serve(15), 3);
  EXPECT_EQ(serve_many(7, 3), (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace castray::tb
