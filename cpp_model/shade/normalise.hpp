// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/shade/normalise.sv: a vector of any length as a unit vector.
#pragma once
#include "fixed.hpp"
#include "math/cordic_sqrt.hpp"
#include "math/div_pipe.hpp"

namespace castray {

inline constexpr int kSquareW = 2 * (static_cast<int>(UnitFrac) + 2);

// Components of up to SpanW bits; zero stays zero.
inline unit3_t normalise(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto magnitude = [](std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); };
  const int shift = msb(magnitude(x) | magnitude(y) | magnitude(z)) - static_cast<int>(UnitFrac);
  const auto scaled = [&](std::int64_t v) { return shift >= 0 ? v >> shift : v * (std::int64_t{1} << -shift); };
  const std::int64_t vx = scaled(x), vy = scaled(y), vz = scaled(z);

  const auto square = static_cast<std::uint64_t>(vx * vx + vy * vy + vz * vz);
  const bool odd = square >> (kSquareW - 2) != 0;
  const std::uint64_t root = cordic_sqrt(square >> (kSquareW - RootRadW - (odd ? 0 : 2)));
  const auto inverse = static_cast<std::int64_t>(div_nearest(std::uint64_t{1} << InverseFrac, root, static_cast<int>(InverseFrac)));
  const auto unit = [&](std::int64_t v) { return round_shift(v * inverse, static_cast<int>(InverseFrac) + odd); };
  unit3_t out;
  out.x = unit(vx);
  out.y = unit(vy);
  out.z = unit(vz);
  return out;
}

}  // namespace castray
