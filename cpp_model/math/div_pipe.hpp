// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/math/div_pipe.sv, and is the model of div_pair.sv (to the nearest) and reciprocal.sv (rounded down).
#pragma once
#include "fixed.hpp"

namespace castray {

// num * 2^qfrac / den to the nearest integer, halves upwards, for num <= den.
// Defined otherwise too: a zero divisor gives 0, num > den gives 2^qfrac.
constexpr std::uint64_t div_nearest(std::uint64_t num, std::uint64_t den, int qfrac) {
  if (den == 0) return 0;
  if (num > den) return std::uint64_t{1} << qfrac;
  return static_cast<std::uint64_t>(((static_cast<uint128>(num) << (qfrac + 1)) / den + 1) >> 1);
}

// The same rounded down.
constexpr std::uint64_t div_floor(std::uint64_t num, std::uint64_t den, int qfrac) {
  if (den == 0) return 0;
  if (num > den) return std::uint64_t{1} << qfrac;
  return static_cast<std::uint64_t>((static_cast<uint128>(num) << qfrac) / den);
}

}  // namespace castray
