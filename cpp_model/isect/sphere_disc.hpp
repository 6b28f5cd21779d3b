// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/sphere_disc.sv: does the ray's line meet the sphere? X, Y: the sheared centre; R: the radius in steps.
#pragma once
#include <cassert>

#include "isect/shear.hpp"

namespace castray {

struct sphere_disc_t {
  bool meets = false;
  std::int64_t disc = 0;     // units of two square steps
  std::int64_t towards = 0;  // X Sx + Y Sy, quarter steps
};

// N = |S|^2 R in units of two steps; norm2 is |S|^2.
inline std::int64_t reach(norm2_t norm2, std::int64_t radius) {
  return round_shift(static_cast<std::int64_t>(norm2) * radius, NormFrac + 1);
}

inline bool radius_legal(std::uint64_t radius) { return radius > 0 && radius < (1u << (CoordW - 1)); }

// Z = X Sy - Y Sx in units of two steps.
inline std::int64_t sphere_cross(const sheared2_t& c, const test_ray_t& ray) {
  return round_shift(c.x * ray.sy - c.y * ray.sx, ShearFrac);
}

inline sphere_disc_t sphere_disc(const sheared2_t& c, std::int64_t radius, const test_ray_t& ray) {
  const std::int64_t cross = sphere_cross(c, ray);
  assert(fits_signed(cross, CoordW + 1));  // the sheared z cancels: Z is (x Sy - y Sx) / 2
  sphere_disc_t s;
  s.disc = reach(ray.norm2, radius) * radius - 2 * (c.x * c.x + c.y * c.y) - 2 * cross * cross;
  s.towards = round_shift(c.x * ray.sx + c.y * ray.sy, ShearFrac - 3);
  s.meets = s.disc >= 0;
  return s;
}

}  // namespace castray
