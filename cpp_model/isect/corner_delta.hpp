// SPDX-License-Identifier: Apache-2.0
// A position seen from the ray's origin, on axes permuted so that the dominant one comes last.
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

inline delta3_t corner_delta(const point_t& p, const point_t& org, axis_t axis) {
  return permute({static_cast<std::int64_t>(p.x - org.x), static_cast<std::int64_t>(p.y - org.y),
                  static_cast<std::int64_t>(p.z - org.z)},
                 axis);
}

}  // namespace castray
