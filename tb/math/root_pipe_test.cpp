// SPDX-License-Identifier: Apache-2.0
// Runs long.
// root_pipe: equal to its model, around squares and at the extremes, with gaps between radicands; one
// root a cycle, RadW / 4 cycles later.
#include "Vroot_pipe.h"
#include "dut.hpp"
#include "math/root_pipe.hpp"

namespace castray::tb {
namespace {

constexpr int kRadW = 56;
constexpr std::uint64_t kLargest = (std::uint64_t{1} << kRadW) - 1;

class RootPipe : public ::testing::TestWithParam<Stalls> {
 protected:
  std::vector<std::uint64_t> run(const std::vector<std::uint64_t>& in, Stalls stalls = {}) {
    const auto got = run_stream<std::uint64_t>(dut, in, in.size(), stalls, 1, 100 * static_cast<long>(in.size()) + 100);
    EXPECT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], isqrt(in[i])) << in[i];
    return got;
  }
  Dut<Vroot_pipe> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, RootPipe, ::testing::ValuesIn(kStallPatterns));

TEST_P(RootPipe, MatchesModel) {
  std::mt19937_64 rng(5);
  std::vector<std::uint64_t> in(6000);
  for (auto& rad : in) rad = (rng() & kLargest) >> (rng() % 4 ? 0 : rng() % kRadW);
  Stalls stalls = GetParam();
  stalls.sink = 0;
  run(in, stalls);
}

TEST_F(RootPipe, IsExactAroundSquares) {
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

TEST_F(RootPipe, KnowsItsExtremes) {
  const auto got = run({0, 1, 2, 3, 4, kLargest, kLargest - 1, std::uint64_t{1} << 54, (std::uint64_t{1} << 54) - 1});
  EXPECT_EQ(got, (std::vector<std::uint64_t>{0, 1, 1, 1, 2, (1 << 28) - 1, (1 << 28) - 1, 1 << 27, (1 << 27) - 1}));
}

TEST_F(RootPipe, GivesOneACycle) {
  dut->in_valid_i = 1;
  for (std::uint64_t cycle = 0; cycle < 60; ++cycle) {
    set_port(dut->in_i, cycle * cycle);
    dut.settle();
    EXPECT_EQ(dut->out_valid_o, cycle >= kRadW / 4);
    if (dut->out_valid_o) EXPECT_EQ(dut->out_o, cycle - kRadW / 4);
    dut.tick();
  }
}

TEST_F(RootPipe, ResetEmptiesIt) {
  dut->in_valid_i = 1;
  for (int cycle = 0; cycle < 10; ++cycle) dut.tick();
  dut->in_valid_i = 0;
  dut.reset(1);
  for (int cycle = 0; cycle < 20; ++cycle, dut.tick()) {
    dut.settle();
    EXPECT_FALSE(dut->out_valid_o);
  }
}

}  // namespace
}  // namespace castray::tb
