// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/camera/slab_setup.sv: the reciprocals of a ray's shear, for the tests of boxes.
#pragma once
#include <algorithm>

#include "math/div_pipe.hpp"

namespace castray {

// One over |s|, rounded down; of zero what is larger than any other.
inline recip_t recip_of(shear_t s) {
  constexpr std::uint64_t kMantMax = (std::uint64_t{1} << RecipW) - 1;
  recip_t r;
  r.zero = s == 0;
  r.minus = s < 0;
  if (r.zero) {
    r.exp = 31;
    r.mant = std::uint64_t{1} << (RecipW - 1);
    return r;
  }
  const auto k = static_cast<std::uint64_t>(s < 0 ? -s : s);
  r.exp = static_cast<std::uint64_t>(static_cast<int>(ShearFrac) - 1 - msb(k));
  r.mant = std::min(div_floor(std::uint64_t{1} << (ShearFrac - 1), k << r.exp, RecipW), kMantMax);
  return r;
}

inline ray_t slab_setup(ray_t ray) {
  ray.rx = recip_of(ray.sx);
  ray.ry = recip_of(ray.sy);
  return ray;
}

}  // namespace castray
