// SPDX-License-Identifier: Apache-2.0
// cordic_sqrt: equal to its model under stalls, at the extremes, and for what is not normalised.
// (Its accuracy: cordic_sqrt_model_test.cpp, every radicand.)
#include "Vcordic_sqrt.h"
#include "blocked.hpp"
#include "math/cordic_sqrt.hpp"

namespace castray::tb {
namespace {

constexpr int kStages = 13;
constexpr std::uint64_t kFirst = 1 << 24, kEnd = 1 << 26;

class CordicSqrt : public ::testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<std::uint64_t>& rads, Stalls stalls = {}) {
    std::vector<std::uint64_t> in;
    for (const auto rad : rads) in.push_back(rad | (in.size() * 1597 & 0xfff) << 26);
    const auto got = run_stream<std::uint64_t>(dut, in, in.size(), stalls);
    ASSERT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_EQ(got[i] >> 18, in[i] >> 26) << "tag";
      EXPECT_EQ(got[i] & 0x3ffff, static_cast<std::uint64_t>(cordic_sqrt(rads[i]))) << rads[i];
    }
  }
  Dut<Vcordic_sqrt> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, CordicSqrt, ::testing::ValuesIn(kStallPatterns));

TEST_P(CordicSqrt, MatchesModel) {
  std::mt19937_64 rng(9);
  std::vector<std::uint64_t> rads(40000);
  for (auto& rad : rads) rad = rng() % 16 ? kFirst + rng() % (kEnd - kFirst) : rng() % kEnd >> rng() % 26;
  run(rads, GetParam());
}

TEST_F(CordicSqrt, MatchesModelAtBothEnds) {
  std::vector<std::uint64_t> rads;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    rads.push_back(kFirst + i);
    rads.push_back(kEnd - 1 - i);
    rads.push_back(CordicStart - 1000 + i);  // around y = 0
  }
  run(rads);
}

TEST_F(CordicSqrt, GivesZeroForWhatIsNotNormalised) {
  const std::vector<std::uint64_t> rads = {0, 1, 2, 1 << 22, kFirst - 2, kFirst - 1};
  for (const auto rad : rads) EXPECT_EQ(cordic_sqrt(rad), 0u);
  run(rads);
}

TEST_F(CordicSqrt, SaturatesAtTheTop) {
  EXPECT_EQ(cordic_sqrt(kEnd - 1), (1u << 18) - 1);
  run({kEnd - 1, kEnd - 2, kEnd - 3});
}

TEST_F(CordicSqrt, FillsEveryStageWhileBlocked) {
  fill_and_drain<std::uint64_t>(dut, kStages, [](int i) { return (kFirst + 1000 * i) | std::uint64_t(i) << 26; },
                                [](int i) { return std::uint64_t(i) << 18 | cordic_sqrt(kFirst + 1000 * i); });
}

}  // namespace
}  // namespace castray::tb
