// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/tile_box.sv: whether some ray of a tile may meet what a box holds.
#pragma once
#include <algorithm>

#include "isect/corner_delta.hpp"

namespace castray {

// How far a reported t may lie before the box, and so a ray beside it: docs/tile-start.md.
inline constexpr std::int64_t kTileSlack = BoxMargin;  // steps

// False only if no ray of the tile meets the box at t > 0.
inline bool tile_box(const tile_bounds_t& bounds, const point_t& eye, const box_t& box) {
  const point_t org = permuted(eye, bounds.axis);
  const delta3_t low = corner_delta(box.low, org, bounds.axis), high = corner_delta(box.high, org, bounds.axis);
  const std::int64_t first = bounds.neg ? -high.z : low.z, last = bounds.neg ? -low.z : high.z;
  const std::int64_t t0 = std::max<std::int64_t>(first, 0), t1 = std::max<std::int64_t>(last, 0);
  // t slope, the farthest to one side over t0 to t1, against a plane of the box.
  const auto reaches = [&](std::int64_t slope, std::int64_t plane) {
    return (slope < 0 ? t0 : t1) * slope >= (plane - kTileSlack) * (1 << TileSlopeFrac);
  };
  return last >= -kTileSlack && reaches(bounds.x_high, low.x) && reaches(-bounds.x_low, -high.x) &&
         reaches(bounds.y_high, low.y) && reaches(-bounds.y_low, -high.y);
}

}  // namespace castray
