// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/shear.sv: a corner moved along the ray onto the plane z = 0, in units of two steps:
// the range is CoordW + 1 bits.
#pragma once
#include "isect/corner_delta.hpp"

namespace castray {

struct sheared2_t {
  sheared_t x = 0, y = 0;
};

// (x - s z) / 2 to the nearest integer, halves upwards.
inline sheared_t shear(std::int64_t x, std::int64_t z, shear_t s) {
  using product_t = int_of<CoordW + ShearFrac + 3>;
  return static_cast<sheared_t>(round_shift((product_t{x} << ShearFrac) - product_t{s} * z, ShearFrac + 1));
}
inline sheared2_t shear(const delta3_t& d, const test_ray_t& ray) {
  return {shear(d.x, d.z, ray.sx), shear(d.y, d.z, ray.sy)};
}

}  // namespace castray
