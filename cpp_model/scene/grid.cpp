// SPDX-License-Identifier: Apache-2.0
#include "scene/grid.hpp"

#include <algorithm>

namespace castray {

Grid finest_grid(const Vec3& low, const Vec3& high) {
  double span = 0;
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    span = std::max(span, high[i] - low[i]);
    largest = std::max({largest, std::abs(low[i]), std::abs(high[i])});
  }
  const auto fits = [&](int power) {
    return std::ldexp(span, -power) < std::ldexp(1.0, CoordW) - Grid::kMargin && std::ldexp(largest, -power) < 0x1p52;
  };
  Grid grid;
  grid.power = Grid::kFinestPower;
  if (!fits(grid.power)) {
    grid.power = std::max(grid.power, std::ilogb(std::max(span, largest)) - 60);
    while (!fits(grid.power)) ++grid.power;
  }
  for (int i = 0; i < 3; ++i)
    grid.corner[i] = static_cast<std::int64_t>(std::floor(std::ldexp(low[i], -grid.power) - Grid::kMargin / 2));
  return grid;
}

}  // namespace castray
