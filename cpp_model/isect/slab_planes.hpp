// SPDX-License-Identifier: Apache-2.0
// Where a ray is between a child's two planes across one axis. RTL: rtl/isect/slab_planes.sv, equal bit for bit.
#pragma once
#include "isect/slab_axis.hpp"

namespace castray {

inline constexpr std::int64_t kTickMax = (std::int64_t{1} << (8 + SubPlane)) - 1;

// A stretch of a ray in ticks of the dominant axis; none: it ends before the node's first plane.
struct span_ticks_t {
  bool none = false;
  std::int64_t low = 0, high = 0;
};

inline std::int64_t to_ticks(slab_t x, int left) {
  if (x <= 0) return 0;
  return x > (kTickMax >> left) ? kTickMax : x << left;
}

inline span_ticks_t slab_planes(const slab_axis_t& axis, std::int64_t q0, std::int64_t q1) {
  const std::int64_t least = (q0 * axis.mant) >> (9 - SubPlane);
  const std::int64_t most = ((q1 * (axis.mant + 1)) >> (9 - SubPlane)) + 1;
  const slab_t low = axis.low + (axis.minus ? -most : least);
  const slab_t high = axis.high + (axis.minus ? -least : most);
  return {high < 0, to_ticks(low, axis.left), to_ticks(high, axis.left)};
}

}  // namespace castray
