// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/sphere_disc.sv: does the ray's line meet the sphere? X, Y: the sheared centre; R: the radius in steps.
#pragma once
#include <algorithm>
#include <cassert>

#include "isect/shear.hpp"

namespace castray {

using sphere_t = int_of<std::max(2 * CoordW + 6, CoordW + ShearFrac + 4)>;

struct sphere_disc_t {
  bool meets = false;
  sphere_t disc = 0;         // units of two square steps
  std::int64_t towards = 0;  // X Sx + Y Sy, quarter steps
};

// N = |S|^2 R in units of two steps; norm2 is |S|^2.
inline std::int64_t reach(norm2_t norm2, std::int64_t radius) {
  return static_cast<std::int64_t>(round_shift(static_cast<sphere_t>(norm2) * radius, NormFrac + 1));
}

inline bool radius_legal(std::uint64_t radius) { return radius > 0 && radius < (std::uint64_t{1} << (CoordW - 1)); }

// Z = X Sy - Y Sx in units of two steps.
inline std::int64_t sphere_cross(const sheared2_t& c, const test_ray_t& ray) {
  return static_cast<std::int64_t>(round_shift(sphere_t{c.x} * ray.sy - sphere_t{c.y} * ray.sx, ShearFrac));
}

inline sphere_disc_t sphere_disc(const sheared2_t& c, std::int64_t radius, const test_ray_t& ray) {
  const std::int64_t cross = sphere_cross(c, ray);
  assert(fits_signed(cross, CoordW + 1));  // the sheared z cancels: Z is (x Sy - y Sx) / 2
  sphere_disc_t s;
  const sphere_t x = c.x, y = c.y, z = cross;
  s.disc = reach(ray.norm2, radius) * sphere_t{radius} - 2 * (x * x + y * y) - 2 * z * z;
  s.towards = static_cast<std::int64_t>(round_shift(x * ray.sx + y * ray.sy, ShearFrac - 3));
  s.meets = s.disc >= 0;
  return s;
}

}  // namespace castray
