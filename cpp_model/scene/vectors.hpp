// SPDX-License-Identifier: Apache-2.0
// Vectors of any length, without overflow.
#pragma once
#include <algorithm>
#include <cmath>

#include "scene/scene.hpp"

namespace castray {

// v of length 1; of zero length if v is zero. Scaled first: the square of a large component would
// overflow, that of a small one vanish.
inline Vec3 unit_or_zero(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0) return Vec3(0);
  const Vec3 scaled = v / largest;
  return scaled / std::sqrt(scaled.dot(scaled));
}

}  // namespace castray
