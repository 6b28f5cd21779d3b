// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/tile_bounds.sv: what the directions of all rays of a tile lie between.
#pragma once
#include <algorithm>
#include <array>

#include "fixed.hpp"

namespace castray {

// The four corner rays in the order of the walk: first row left, right, last row left, right.
using CornerRays = std::array<ray_t, 4>;

// dx/dt of the tile's rays lies in [low, high], rounded outward to 16 fraction bits.
inline tile_bounds_t tile_bounds(const CornerRays& corners) {
  tile_bounds_t bounds;
  const ray_t& first = corners[0];
  bounds.valid = std::all_of(corners.begin(), corners.end(), [&](const ray_t& ray) {
    return ray.valid && ray.axis == first.axis && ray.neg == first.neg;
  });
  bounds.axis = first.axis;
  bounds.neg = first.neg;
  const auto range = [&](shear_t ray_t::*shear, tile_slope_t& low, tile_slope_t& high) {
    std::int64_t least = INT64_MAX, most = INT64_MIN;
    for (const ray_t& ray : corners) {
      const std::int64_t slope = first.neg ? -(ray.*shear) : ray.*shear;
      least = std::min(least, slope);
      most = std::max(most, slope);
    }
    // A last bit beyond the corners: docs/tile-start.md.
    constexpr int kDrop = ShearFrac - TileSlopeFrac;
    low = (least - 1) >> kDrop;
    high = (most + 1 + (std::int64_t{1} << kDrop) - 1) >> kDrop;
  };
  range(&ray_t::sx, bounds.x_low, bounds.x_high);
  range(&ray_t::sy, bounds.y_low, bounds.y_high);
  return bounds;
}

}  // namespace castray
