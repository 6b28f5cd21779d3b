// SPDX-License-Identifier: Apache-2.0
// Seeded rays and primitives for the tests of the primitive pipe and the hit unit.
#pragma once
#include <algorithm>
#include <random>

#include "isect/ray_prim.hpp"

namespace castray::tb {

inline constexpr std::int64_t kGrid = (std::int64_t{1} << CoordW) - 64;  // positions are below this
inline constexpr std::int64_t kHalf = std::int64_t{1} << (CoordW - 1);   // the middle; radii are below this
inline constexpr std::int64_t kOne = std::int64_t{1} << ShearFrac;

inline std::uint64_t norm2_of(std::int64_t sx, std::int64_t sy) {
  return static_cast<std::uint64_t>(round_shift(kOne * kOne + sx * sx + sy * sy, 2 * ShearFrac - NormFrac));
}

struct Rng : std::mt19937_64 {
  using std::mt19937_64::mt19937_64;
  std::int64_t in(std::int64_t lo, std::int64_t hi) {
    return lo + static_cast<std::int64_t>((*this)() % static_cast<std::uint64_t>(hi - lo + 1));
  }
  bool chance(int n) { return in(1, n) == 1; }
  // A grid coordinate: uniform, small scale around a place, or an extreme.
  std::uint64_t coord() {
    switch (in(0, 7)) {
      case 0: return 0;
      case 1: return kGrid - 1;
      case 2: return static_cast<std::uint64_t>(in(0, 15));
      default: return static_cast<std::uint64_t>(in(0, kGrid - 1));
    }
  }
  std::int64_t shear() {
    switch (in(0, 9)) {
      case 0: return kOne - 1;
      case 1: return 1 - kOne;
      case 2: return 0;
      case 3: return in(-3, 3);
      default: return in(1 - kOne, kOne - 1);
    }
  }
  point_t point() {
    point_t p;
    p.x = coord(), p.y = coord(), p.z = coord();
    return p;
  }
  test_ray_t ray() {
    test_ray_t r;
    r.org = point();
    r.sx = shear(), r.sy = shear();
    r.norm2 = norm2_of(r.sx, r.sy);
    r.axis = static_cast<axis_t>(in(0, 2));
    r.neg = chance(2), r.cull = chance(3);
    return r;
  }
  // A point at z along the ray, moved by up to `off` steps, kept inside the grid.
  point_t near_ray(const test_ray_t& ray, std::int64_t off);
};

inline std::int64_t clamp_grid(std::int64_t x) { return std::clamp<std::int64_t>(x, 0, kGrid - 1); }

// org + d, both on permuted axes, kept inside the grid.
inline point_t at_delta(const test_ray_t& ray, const delta3_t& d) {
  const auto at = [](coord_t org, std::int64_t by) { return clamp_grid(static_cast<std::int64_t>(org) + by); };
  const delta3_t w = unpermute({at(ray.org.x, d.x), at(ray.org.y, d.y), at(ray.org.z, d.z)}, ray.axis);
  point_t p;
  p.x = static_cast<std::uint64_t>(w.x), p.y = static_cast<std::uint64_t>(w.y), p.z = static_cast<std::uint64_t>(w.z);
  return p;
}

inline point_t Rng::near_ray(const test_ray_t& ray, std::int64_t off) {
  const std::int64_t z = chance(4) ? in(-1000, 1000) : in(-kGrid, kGrid);
  return at_delta(ray, {((ray.sx * z) >> ShearFrac) + in(-off, off), ((ray.sy * z) >> ShearFrac) + in(-off, off), z});
}

struct PrimCase {
  test_ray_t ray;
  prim_slot_t prim;
  ctx_t ctx = 0;
};

// A radius of any size, seldom a large one.
inline std::uint64_t random_radius(Rng& rng) {
  return static_cast<std::uint64_t>(rng.in(1, std::int64_t{1} << rng.in(1, CoordW - 1))) & (kHalf - 1);
}

// A test of which a good share is accepted: primitives gather around the ray's line.
inline PrimCase random_case(Rng& rng) {
  PrimCase c;
  c.ray = rng.ray();
  c.ctx = static_cast<ctx_t>(rng.in(0, 63));
  c.prim.number = rng.chance(40) ? NoPrim : static_cast<prim_t>(rng.in(0, NoPrim - 1));
  const std::int64_t off = std::int64_t{1} << rng.in(0, CoordW - 1);
  if (rng.chance(4)) {
    c.prim.kind = KindSphere;
    c.prim.a = rng.chance(4) ? rng.point() : rng.near_ray(c.ray, off);
    c.prim.b = rng.point();
    c.prim.c = rng.point();
    c.prim.b.x = static_cast<std::uint64_t>(rng.chance(8)   ? kHalf - 1
                                            : rng.chance(8) ? rng.in(0, 3)
                                            : rng.chance(9) ? rng.in(kHalf, 2 * kHalf - 1)
                                                            : rng.in(0, std::min<std::int64_t>(2 * off, kHalf - 1)));
    return c;
  }
  c.prim.kind = KindTriangle;
  c.prim.a = rng.chance(4) ? rng.point() : rng.near_ray(c.ray, off);
  c.prim.b = rng.chance(4) ? rng.point() : rng.near_ray(c.ray, off);
  c.prim.c = rng.chance(4) ? rng.point() : rng.near_ray(c.ray, off);
  // Degenerate ones: two corners alike, or three in a line.
  if (rng.chance(30)) c.prim.b = c.prim.a;
  if (rng.chance(30)) c.prim.c = c.prim.b;
  if (rng.chance(30)) {
    c.prim.c.x = (c.prim.a.x + c.prim.b.x) / 2, c.prim.c.y = (c.prim.a.y + c.prim.b.y) / 2;
    c.prim.c.z = (c.prim.a.z + c.prim.b.z) / 2;
  }
  return c;
}

}  // namespace castray::tb
