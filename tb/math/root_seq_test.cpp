// SPDX-License-Identifier: Apache-2.0
// root_seq: equal to its model, around squares and at the extremes, under stalls; one root every
// RadW / 4 + 1 cycles, and a root that is not taken waits.
#include "Vroot_seq.h"
#include "dut.hpp"
#include "math/root_seq.hpp"

namespace castray::tb {
namespace {

constexpr int kRadW = 56;
constexpr std::uint64_t kLargest = (std::uint64_t{1} << kRadW) - 1;

class RootSeq : public ::testing::TestWithParam<Stalls> {
 protected:
  std::vector<std::uint64_t> run(const std::vector<std::uint64_t>& in, Stalls stalls = {}) {
    const auto got = run_stream<std::uint64_t>(dut, in, in.size(), stalls, 1, 100 * static_cast<long>(in.size()) + 100);
    EXPECT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], isqrt(in[i])) << in[i];
    return got;
  }
  Dut<Vroot_seq> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, RootSeq, ::testing::ValuesIn(kStallPatterns));

TEST_P(RootSeq, MatchesModel) {
  std::mt19937_64 rng(5);
  std::vector<std::uint64_t> in(6000);
  for (auto& rad : in) rad = (rng() & kLargest) >> (rng() % 4 ? 0 : rng() % kRadW);
  run(in, GetParam());
}

TEST_F(RootSeq, IsExactAroundSquares) {
  std::mt19937_64 rng(6);
  std::vector<std::uint64_t> in;
  const auto around = [&](std::uint64_t k) {
    for (const std::uint64_t rad : {k * k - 1, k * k, k * k + 1}) in.push_back(rad & kLargest);
  };
  for (std::uint64_t k = 1; k < 200; ++k) around(k);
  for (int bit = 0; bit < kRadW / 2; ++bit)  // powers of four, and squares of 01...1 and 10...01
    for (const int by : {-1, 0, 1}) around((std::uint64_t{1} << bit) + by);
  for (int i = 0; i < 1000; ++i) around(rng() % (1 << (kRadW / 2)));
  run(in);
}

TEST_F(RootSeq, KnowsItsExtremes) {
  const auto got = run({0, 1, 2, 3, 4, kLargest, kLargest - 1, std::uint64_t{1} << 54, (std::uint64_t{1} << 54) - 1});
  EXPECT_EQ(got, (std::vector<std::uint64_t>{0, 1, 1, 1, 2, (1 << 28) - 1, (1 << 28) - 1, 1 << 27, (1 << 27) - 1}));
}

TEST_F(RootSeq, TakesOneEveryFifteenCycles) {
  dut->in_valid_i = 1;
  dut->out_ready_i = 1;
  set_port(dut->in_i, std::uint64_t{81});
  std::vector<int> taken, given;
  for (int cycle = 0; cycle < 60; ++cycle) {
    dut.settle();
    if (dut->in_ready_o) taken.push_back(cycle);
    if (dut->out_valid_o) given.push_back(cycle);
    dut.tick();
  }
  EXPECT_EQ(taken, (std::vector<int>{0, 15, 30, 45}));
  EXPECT_EQ(given, (std::vector<int>{15, 30, 45}));
}

TEST_F(RootSeq, HoldsOneWhileBlocked) {
  dut->in_valid_i = 1;
  dut->out_ready_i = 0;
  int taken = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    set_port(dut->in_i, taken ? std::uint64_t{9} : std::uint64_t{49});
    dut.settle();
    taken += dut->in_ready_o;
    EXPECT_EQ(dut->out_valid_o, cycle >= 15);
    if (dut->out_valid_o) EXPECT_EQ(dut->out_o, 7u);
    dut.tick();
  }
  EXPECT_EQ(taken, 1);
}

}  // namespace
}  // namespace castray::tb
