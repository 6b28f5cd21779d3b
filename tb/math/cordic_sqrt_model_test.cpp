// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The CORDIC square root's accuracy, proven: every normalised radicand, in exact integers.
#include <gtest/gtest.h>

#include <cmath>

#include "math/cordic_sqrt.hpp"

namespace castray::tb {

constexpr std::int32_t kFirst = 1 << 24;
constexpr std::int32_t kEnd = 1 << 26;

// |root - 32 sqrt(rad)| <= 3/4, both sides times 4 and squared; the largest root, where the
// exact one would round to 2^18, is 1 from it at most.
TEST(CordicSqrtModel, EveryRadicandIsWithinItsBound) {
  std::int64_t wrong = 0;
  std::int32_t lowest = kEnd;
  for (std::int32_t rad = kFirst; rad < kEnd; ++rad) {
    const std::int32_t root = cordic_sqrt(rad);
    const std::int64_t low = 4 * std::int64_t{root} - 3;
    const std::int64_t high = low + (root == (1 << 18) - 1 ? 7 : 6);
    const std::int64_t exact = std::int64_t{rad} << 14;  // (4 * 32)^2 rad
    wrong += (low * low > exact) | (high * high < exact) | (root >= 1 << 18);
    lowest = std::min(lowest, root);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(lowest, 1 << 17) << "the reciprocal's divisor is at least 2^17";
}

// C = 2^(RootRadW-2) / product of (1 - 4^-shift), to the nearest integer.
TEST(CordicSqrtModel, StartsWithTheConstantOfItsSteps) {
  long double start = 1L << (RootRadW - 2);
  for (int shift = 1; shift < CordicSteps; ++shift)
    for (int times = shift == CordicRepeat ? 2 : 1; times > 0; --times) start /= 1 - std::ldexp(1.0L, -2 * shift);
  EXPECT_EQ(CordicStart, std::llround(start));
}

TEST(CordicSqrtModel, PowersOfFourAreExact) {
  EXPECT_EQ(cordic_sqrt(1 << 24), 1 << 17);
  EXPECT_EQ(cordic_sqrt(9 << 22), 3 << 16);
}

TEST(CordicSqrtModel, UnnormalisedGivesZero) {
  for (std::int32_t rad = 0; rad < kFirst; ++rad) ASSERT_EQ(cordic_sqrt(rad), 0) << rad;
}

}  // namespace castray::tb
