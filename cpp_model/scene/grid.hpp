// SPDX-License-Identifier: Apache-2.0
// The grid of a scene image: positions are whole steps of 2^power scene units from a corner.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "castray_records.hpp"
#include "scene/box.hpp"
#include "scene/scene.hpp"

namespace castray {

struct Grid {
  // Steps of the range that stay unused, half below, half above: room for the padding of boxes.
  static constexpr double kMargin = 2 * std::bit_ceil(std::uint64_t{sphere_padding((std::int64_t{1} << (CoordW - 1)) - 1)});
  static constexpr int kFinestPower = -100;

  int power = 0;
  std::int64_t corner[3] = {};  // steps from the world's origin

  double step() const { return std::ldexp(1.0, power); }

  // A coordinate in steps from the corner, to the nearest. Not checked against the range.
  std::int64_t at(double x, int axis) const { return std::llround(std::ldexp(x, -power)) - corner[axis]; }
  static bool holds(std::int64_t steps) { return steps >= 0 && steps < (std::int64_t{1} << CoordW); }
};

// The finest grid on which the box from low to high spans less than 2^CoordW - kMargin steps, and on
// which its coordinates are exact in double.
Grid finest_grid(const Vec3& low, const Vec3& high);

}  // namespace castray
