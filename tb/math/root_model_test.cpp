// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The integer square root of the model is the true one: r^2 <= rad < (r + 1)^2.
#include <gtest/gtest.h>

#include <random>

#include "math/root_pipe.hpp"

namespace castray::tb {
namespace {

bool is_root(std::uint64_t rad) {
  const std::uint64_t r = isqrt(rad);
  return r < std::uint64_t{1} << 31 && r * r <= rad && rad < (r + 1) * (r + 1);
}

TEST(RootModel, IsTheTrueRootOfTenMillion) {
  std::mt19937_64 rng(1);
  int wrong = 0;
  for (int i = 0; i < 10'000'000; ++i) wrong += !is_root(rng() >> (2 + (i % 4 ? 0 : i / 4 % 62)));
  EXPECT_EQ(wrong, 0);
}

// k of every size up to 2^31: all small ones, then ever wider steps.
TEST(RootModel, IsTheTrueRootAroundSquares) {
  for (std::uint64_t k = 1; k < std::uint64_t{1} << 31; k += 1 + k / 65536)
    for (const std::uint64_t rad : {k * k - 1, k * k, k * k + 1}) ASSERT_TRUE(is_root(rad)) << rad;
}

TEST(RootModel, IsTheTrueRootAroundPowersOfTwo) {
  EXPECT_EQ(isqrt(0), 0u);
  for (int bit = 0; bit < 62; ++bit)
    for (const int by : {-1, 0, 1}) EXPECT_TRUE(is_root((std::uint64_t{1} << bit) + by)) << bit;
  const std::uint64_t largest = (std::uint64_t{1} << 62) - 1;
  EXPECT_EQ(isqrt(largest), (std::uint64_t{1} << 31) - 1);
  for (std::uint64_t k = (std::uint64_t{1} << 31) - 1000; k < std::uint64_t{1} << 31; ++k) {
    EXPECT_EQ(isqrt(k * k), k);
    EXPECT_EQ(isqrt(k * k - 1), k - 1);
  }
}

}  // namespace
}  // namespace castray::tb
