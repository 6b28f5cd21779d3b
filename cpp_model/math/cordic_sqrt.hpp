// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/math/cordic_sqrt.sv: square root by hyperbolic CORDIC in vectoring mode (Walther, "A
// unified algorithm for elementary functions", 1971).
#pragma once
#include "fixed.hpp"

namespace castray {

inline constexpr int RootW = static_cast<int>(RootRadW / 2 + RootFrac);

// A step is repeated, so that what is left of y after each is within reach of the later ones.
// y enters the error of x squared: steps up to 10 leave 2^-21 of it.
//
// The steps shrink sqrt(x^2 - y^2) by K = product of sqrt(1 - 4^-step) = 0.82815949876. Starting
// with x = r + c, y = r - c, c = 1 / (4 K^2), leaves x = sqrt(r): no product at the end.
//
// The root of rad (26 bits, at least 2^24) in Q13.5, within 3/4 of the last place (the largest,
// 2^18 - 1, within 1); 0 for a smaller rad.
constexpr std::uint64_t cordic_sqrt(std::uint64_t rad) {
  if (rad >> (RootRadW - 2) == 0) return 0;
  std::int64_t x = static_cast<std::int64_t>(rad) + CordicStart;
  std::int64_t y = static_cast<std::int64_t>(rad) - CordicStart;
  for (int k = 1; k <= CordicSteps; ++k) {
    const int step = k <= CordicRepeat ? k : k - 1;
    const std::int64_t dx = y >> step, dy = x >> step;
    const bool down = y >= 0;
    x = down ? x - dx : x + dx;
    y = down ? y - dy : y + dy;
  }
  // x is the root of rad / 2^26 with 26 fraction bits: 8 more than asked for.
  const std::int64_t root = round_shift(x, static_cast<int>(RootRadW) - RootW);
  const std::int64_t largest = (std::int64_t{1} << RootW) - 1;
  return static_cast<std::uint64_t>(root > largest ? largest : root);
}

}  // namespace castray
