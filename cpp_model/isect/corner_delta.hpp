// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/corner_delta.sv: a position seen from the ray's origin, on axes permuted so that
// the dominant one comes last. And rtl/shade/unpermute.sv: the way back.
#pragma once
#include "fixed.hpp"

namespace castray {

struct delta3_t {
  std::int64_t x = 0, y = 0, z = 0;
};

// Cyclic: (x, y, z) becomes (y, z, x) for axis 0, (z, x, y) for axis 1, itself for axis 2 (and 3).
inline delta3_t permute(const delta3_t& v, axis_t axis) {
  switch (axis) {
    case 0: return {v.y, v.z, v.x};
    case 1: return {v.z, v.x, v.y};
    default: return v;
  }
}
// The inverse of permute.
inline delta3_t unpermute(const delta3_t& v, axis_t axis) {
  switch (axis) {
    case 0: return {v.z, v.x, v.y};
    case 1: return {v.y, v.z, v.x};
    default: return v;
  }
}

// One axis: exact below 2^CoordW; of what a wider field of a record may hold, modulo 2^(CoordW+1).
inline std::int64_t delta_of(coord_t p, coord_t org) {
  const std::int64_t d = static_cast<std::int64_t>(p - org);
  if constexpr (CoordW < CoordFieldW) return wrap_signed(d, CoordW + 1);
  return d;
}

inline point_t permuted(const point_t& p, axis_t axis) {
  switch (axis) {
    case 0: return {.z = p.x, .y = p.z, .x = p.y};
    case 1: return {.z = p.y, .y = p.x, .x = p.z};
    default: return p;
  }
}

// org is permuted already.
inline delta3_t corner_delta(const point_t& p, const point_t& org, axis_t axis) {
  const point_t at = permuted(p, axis);
  return {delta_of(at.x, org.x), delta_of(at.y, org.y), delta_of(at.z, org.z)};
}

}  // namespace castray
