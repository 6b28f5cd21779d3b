// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/hit_distance.sv: from two quotients to the distance along the ray.
#pragma once
#include <algorithm>

#include "isect/hit_norm.hpp"

namespace castray {

// A quotient times its scale, and the sum of two.
using along_t = int_of<CoordW + std::max(BaryFrac, HitDivW) + 8>;

inline t_t clamp_t(std::int64_t t) { return t > TMax ? TMax : t < -TMax ? -TMax : t; }

// t = Cz + u (Az - Cz) + v (Bz - Cz), turned into the ray's direction.
inline t_t triangle_distance(std::int64_t cz, along_t part0, along_t part1, bool neg) {
  const auto z = (cz << TFrac) + static_cast<std::int64_t>(round_shift(part0 + part1, BaryFrac - TFrac));
  return clamp_t(neg ? -z : z);
}

// The centre's distance and a root's, which has 2 fraction bits.
inline t_t sphere_distance(std::int64_t cz, along_t part, bool neg) {
  return clamp_t(((neg ? -cz : cz) << TFrac) + (static_cast<std::int64_t>(part) << (TFrac - 2)));
}

}  // namespace castray
