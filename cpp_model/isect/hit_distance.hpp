// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/hit_distance.sv: from two quotients to the distance along the ray.
#pragma once
#include "isect/hit_norm.hpp"

namespace castray {

inline t_t clamp_t(std::int64_t t) { return t > TMax ? TMax : t < -TMax ? -TMax : t; }

// t = Cz + u (Az - Cz) + v (Bz - Cz), turned into the ray's direction.
inline t_t triangle_distance(std::int64_t cz, std::int64_t part0, std::int64_t part1, bool neg) {
  const std::int64_t z = (cz << TFrac) + round_shift(part0 + part1, BaryFrac - TFrac);
  return clamp_t(neg ? -z : z);
}

// The centre's distance and a root's, which has 2 fraction bits.
inline t_t sphere_distance(std::int64_t cz, std::int64_t part, bool neg) {
  return clamp_t(((neg ? -cz : cz) << TFrac) + (part << (TFrac - 2)));
}

}  // namespace castray
