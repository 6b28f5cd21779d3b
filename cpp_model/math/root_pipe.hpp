// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/math/root_pipe.sv: integer square root.
#pragma once
#include <cmath>

#include "fixed.hpp"

namespace castray {

// The largest r with r^2 <= rad, for rad < 2^62: the estimate in double is off by one at most. Of 128 bits, below 2^100:
// the estimate's error is squared by halving it with rad / root.
template <class Rad> std::uint64_t isqrt(Rad rad) {
  using Wide = std::conditional_t<sizeof(Rad) <= 8, std::uint64_t, uint128>;
  const auto square = static_cast<Wide>(rad);
  auto root = static_cast<Wide>(std::sqrt(static_cast<double>(square)));
  if constexpr (sizeof(Rad) > 8)
    if (root > 0) root = (root + square / root) / 2;
  if (root * root > square) return static_cast<std::uint64_t>(root - 1);
  if ((root + 1) * (root + 1) <= square) return static_cast<std::uint64_t>(root + 1);
  return static_cast<std::uint64_t>(root);
}

}  // namespace castray
