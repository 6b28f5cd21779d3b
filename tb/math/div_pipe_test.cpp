// SPDX-License-Identifier: Apache-2.0
// Runs long.
// div_pipe: equal to its model under stalls, for the width that the core uses, for others, and for stages that
// do not divide the digits evenly; ties, extremes and the guarded results by hand.
#include "Vdiv_pipe.h"
#include "blocked.hpp"
#include "math/div_pipe.hpp"

namespace castray::tb {
namespace {

// As in div_pipe_tb.sv.
struct Config {
  int num_w, qfrac, bits;
  int stages() const { return (qfrac + 2 + bits - 1) / bits + 1; }
  std::uint64_t largest() const { return (std::uint64_t{1} << num_w) - 1; }
};
constexpr Config kConfigs[] = {{32, 26, 2}, {32, 26, 1}, {26, 24, 3}, {18, 17, 2}};
constexpr int kCount = std::size(kConfigs);

struct Division {
  static constexpr int kBits = 80;
  std::uint64_t num = 0, den = 0, tag = 0;
  template <class F> void each_field(F&& f) const {
    f("num", num, 0, 32, false);
    f("den", den, 32, 32, false);
    f("tag", tag, 64, 16, false);
  }
};
struct Quotient {
  static constexpr int kBits = 48;
  std::uint64_t q = 0, tag = 0;
  template <class F> void each_field(F&& f) {
    f("q", q, 0, 32, false);
    f("tag", tag, 32, 16, false);
  }
  bool operator==(const Quotient&) const = default;
};

class DivPipe : public ::testing::TestWithParam<std::tuple<int, Stalls>> {
 protected:
  void choose(int which) {
    config = kConfigs[which];
    dut->which_i = which;
  }
  std::vector<Quotient> run(std::vector<Division> in, Stalls stalls = {}) {
    for (std::size_t i = 0; i < in.size(); ++i) in[i].tag = (i * 40503) & 0xffff;
    const auto got = run_stream<Quotient>(dut, in, in.size(), stalls);
    EXPECT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_EQ(got[i].tag, in[i].tag);
      EXPECT_EQ(got[i].q, model(in[i].num, in[i].den)) << in[i].num << " / " << in[i].den;
    }
    return got;
  }
  std::uint64_t model(std::uint64_t num, std::uint64_t den) const {
    return div_nearest(num, den, config.qfrac);
  }
  std::uint64_t divide(std::uint64_t num, std::uint64_t den) { return run({{num, den}}).at(0).q; }

  Dut<Vdiv_pipe> dut;
  Config config = kConfigs[0];
  std::mt19937_64 rng{7};

  // num <= den, both of any magnitude; now and then equal, or not allowed.
  Division random_division() {
    std::uint64_t den = (rng() & config.largest()) >> (rng() % 4 ? 0 : rng() % config.num_w);
    std::uint64_t num = (rng() & config.largest()) >> (rng() % 2 ? 0 : rng() % config.num_w);
    if (num > den && rng() % 32) std::swap(num, den);
    if (rng() % 32 == 0) num = den - (den != 0 && rng() % 2);
    return {num, den};
  }
};
INSTANTIATE_TEST_SUITE_P(Configs, DivPipe, ::testing::Combine(::testing::Range(0, kCount), ::testing::ValuesIn(kStallPatterns)));

TEST_P(DivPipe, MatchesModel) {
  choose(std::get<0>(GetParam()));
  std::vector<Division> in(8000);
  for (auto& division : in) division = random_division();
  run(in, std::get<1>(GetParam()));
}

// q - 1/2 <= exact < q + 1/2, or q <= exact < q + 1, all times 2 den.
TEST_F(DivPipe, ModelIsTheNearestOrTheNextBelow) {
  for (const Config& each : kConfigs) {
    config = each;
    for (int i = 0; i < 200000; ++i) {
      const Division d = random_division();
      if (d.den == 0 || d.num > d.den) continue;
      const int128 from = 2 * static_cast<int128>(model(d.num, d.den)) - 1;
      const int128 exact = static_cast<int128>(d.num) << (config.qfrac + 1);
      ASSERT_TRUE(from * d.den <= exact && exact < (from + 2) * d.den) << d.num << " / " << d.den;
    }
  }
}

TEST_F(DivPipe, RoundsTiesUp) {
  for (const int which : {0, 1}) {
    choose(which);
    // A quotient of k + 1/2 units exactly, and its neighbours to either side.
    for (const std::uint64_t k : {0ull, 1ull, 2ull, 12345ull, (1ull << 26) - 1}) {
      const std::uint64_t den = 1ull << 31, tie = (2 * k + 1) << 4;
      EXPECT_EQ(divide(tie, den), k + 1);
      EXPECT_EQ(divide(tie - 1, den), k);
      EXPECT_EQ(divide(tie + 1, den), k + 1);
    }
    // Ties over a divisor that is no power of two: 1/2 and 3/2 units.
    EXPECT_EQ(divide(7, 7 << 27), 1u);
    EXPECT_EQ(divide(6, 7 << 27), 0u);
    EXPECT_EQ(divide(21, 7 << 27), 2u);
    EXPECT_EQ(divide(20, 7 << 27), 1u);
  }
}

TEST_F(DivPipe, KnowsItsExtremes) {
  for (int which = 0; which < kCount; ++which) {
    choose(which);
    const std::uint64_t one = std::uint64_t{1} << config.qfrac, top = config.largest();
    EXPECT_EQ(divide(0, 1), 0u);
    EXPECT_EQ(divide(0, top), 0u);
    EXPECT_EQ(divide(1, 1), one);
    EXPECT_EQ(divide(top, top), one);
    EXPECT_EQ(divide(1, 2), one / 2);
    EXPECT_EQ(divide(1, 3), (one + 1) / 3);
    EXPECT_EQ(divide(top / 2, top), one / 2) << "just below a half";
    EXPECT_EQ(divide(top - 1, top), config.num_w > config.qfrac + 1 ? one : model(top - 1, top));
  }
}

TEST_F(DivPipe, GuardsItsDivisor) {
  for (int which = 0; which < kCount; ++which) {
    choose(which);
    const std::uint64_t one = std::uint64_t{1} << config.qfrac, top = config.largest();
    EXPECT_EQ(divide(0, 0), 0u);
    EXPECT_EQ(divide(1, 0), 0u);
    EXPECT_EQ(divide(top, 0), 0u);
    EXPECT_EQ(divide(2, 1), one);
    EXPECT_EQ(divide(top, top - 1), one);
    EXPECT_EQ(divide(top, 1), one);
  }
}

TEST_F(DivPipe, FillsEveryStageWhileBlocked) {
  for (int which = 0; which < kCount; ++which) {
    choose(which);
    fill_and_drain<Quotient>(dut, config.stages(), [](int i) { return Division{static_cast<std::uint64_t>(i), 1000, static_cast<std::uint64_t>(i)}; },
                             [&](int i) { return Quotient{model(i, 1000), static_cast<std::uint64_t>(i)}; });
  }
}

}  // namespace
}  // namespace castray::tb
