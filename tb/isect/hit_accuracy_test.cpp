// SPDX-License-Identifier: Apache-2.0
// Runs long.
// How far the model's t, u and v may be from the exact intersection of the rounded ray: bounds
// derived from the formats (docs/number-formats.md), checked against exact integers.
#include <gtest/gtest.h>

#include <cmath>

#include "isect/hit_unit.hpp"
#include "prim_cases.hpp"

namespace castray::tb {
namespace {

using real = long double;

struct Vec {
  int128 x, y, z;
};
Vec minus(const delta3_t& a, const delta3_t& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec cross3(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

hit_ray_t hit_ray(const test_ray_t& ray, t_t tmin) {
  hit_ray_t h;
  h.norm2 = ray.norm2, h.neg = ray.neg, h.tmin = tmin;
  return h;
}

}  // namespace

// A sheared corner is off by at most one step in x and in y. On the triangle's plane, z = z0 + gx X
// + gy Y, weights that sum to one and meet the rounded corners so miss z0 by at most |gx| + |gy|.
// Each quotient is off by less than 2^-24: 2^-25 from the truncated operands, 2^-25 from rounding.
// The sum is rounded to 1/16.
TEST(HitAccuracy, TriangleWithinItsBound) {
  Rng rng(51);
  real worst = 0, worst_arith = 0, worst_steps = 0;
  int tested = 0;
  while (tested < 400000) {
    const PrimCase p = random_case(rng);
    cand_t cand;
    if (p.prim.kind != KindTriangle || !ray_prim(p.ray, p.prim, 0, cand)) continue;
    result_t hit;
    hit_unit(cand, hit_ray(p.ray, -TMax - 1), hit);
    const delta3_t a = corner_delta(p.prim.a, p.ray.org, p.ray.axis), b = corner_delta(p.prim.b, p.ray.org, p.ray.axis),
                   c = corner_delta(p.prim.c, p.ray.org, p.ray.axis);
    const Vec n = cross3(minus(b, a), minus(c, a));
    const int128 along = n.x * p.ray.sx + n.y * p.ray.sy + n.z * kOne;  // n . d, 26 fraction bits
    const int128 depth = n.x * a.x + n.y * a.y + n.z * a.z;
    const real t = static_cast<real>(hit.t) / 16 * (p.ray.neg ? -1 : 1);
    const real du = std::abs(static_cast<real>(a.z - c.z)), dv = std::abs(static_cast<real>(b.z - c.z));

    // The arithmetic behind the test alone: exact U, V, det.
    const real exact_u = static_cast<real>(cand.u) / static_cast<real>(cand.det), exact_v = static_cast<real>(cand.v) / static_cast<real>(cand.det);
    ASSERT_LE(std::abs(static_cast<real>(hit.u) * 0x1p-24L - exact_u), 0x1p-24L) << to_text(cand);
    ASSERT_LE(std::abs(static_cast<real>(hit.v) * 0x1p-24L - exact_v), 0x1p-24L) << to_text(cand);
    const real z = static_cast<real>(c.z) + exact_u * static_cast<real>(a.z - c.z) + exact_v * static_cast<real>(b.z - c.z);
    const real arith = 0x1p-24L * (du + dv) + 1.0L / 32;
    ASSERT_LE(std::abs(t - z), arith + 1e-9L) << to_text(cand);
    worst_arith = std::max(worst_arith, std::abs(t - z) / arith);

    // The whole: the ray against the plane of the triangle's corners.
    ++tested;
    if (along == 0) continue;
    const real exact = static_cast<real>(depth) / static_cast<real>(along) * static_cast<real>(kOne);
    const real slope = (std::abs(static_cast<real>(n.x)) + std::abs(static_cast<real>(n.y))) * static_cast<real>(kOne) / std::abs(static_cast<real>(along));
    ASSERT_LE(std::abs(t - exact), slope * (1 + 1e-9L) + arith + 1e-6L) << to_text(p.ray) << "\n" << to_text(p.prim);
    worst = std::max(worst, std::abs(t - exact) / (slope + arith));
    if (slope < 4) worst_steps = std::max(worst_steps, std::abs(t - exact));
  }
  std::printf("triangles: worst %.3Lf of the bound on t, %.3Lf of the divider's share; %.2Lf steps where the slope is below 4\n", worst, worst_arith, worst_steps);
  EXPECT_GT(worst, 0.3L);  // the bound is not idle
  EXPECT_GT(worst_arith, 0.5L);
  EXPECT_LE(worst_steps, 8 + 1.0L / 32 + 4);
}

// How far the reported point is from the sphere's surface. The rounded centre is off by one step in
// x and y, |S|^2 R by half a step of radius and 2^-26 of it, Z by one step; the roots by 5/8 of a step
// along the ray and by 1.75 2^-23 of the depth from the centre, which is at most R.
TEST(HitAccuracy, SpherePointWithinItsBoundOfTheSurface) {
  Rng rng(52);
  real worst = 0, worst_steps = 0, worst_small = 0, worst_t = 0;
  int tested = 0;
  while (tested < 400000) {
    PrimCase p = random_case(rng);
    p.prim.kind = KindSphere;
    p.prim.b.x = random_radius(rng);
    cand_t cand;
    if (!ray_prim(p.ray, p.prim, 0, cand)) continue;
    const delta3_t c = corner_delta(p.prim.a, p.ray.org, p.ray.axis);
    const real sx = static_cast<real>(p.ray.sx) / kOne, sy = static_cast<real>(p.ray.sy) / kOne, s2 = 1 + sx * sx + sy * sy;
    const real radius = static_cast<real>(p.prim.b.x);
    result_t hit;
    t_t tmin = -TMax - 1;
    for (int root = 0; root < 2; ++root) {
      if (!hit_unit(cand, hit_ray(p.ray, tmin), hit) || std::abs(hit.t) == TMax) break;
      tmin = hit.t;  // the other root next
      ++tested;
      const real z = static_cast<real>(hit.t) / 16 * (p.ray.neg ? -1 : 1);
      const real dx = z * sx - static_cast<real>(c.x), dy = z * sy - static_cast<real>(c.y), dz = z - static_cast<real>(c.z);
      const real off = std::abs(std::sqrt(dx * dx + dy * dy + dz * dz) - radius);
      const real bound = 3 + std::sqrt(s2) * (0.625L + radius * 1.75L * 0x1p-23L);
      ASSERT_LE(off, bound) << to_text(p.ray) << "\n" << to_text(p.prim);
      worst = std::max(worst, off / bound);
      worst_steps = std::max(worst_steps, off);
      if (radius < (1 << 20)) worst_small = std::max(worst_small, off);
      // Along the ray, where the line passes within 0.9 R of the centre.
      const real b = static_cast<real>(c.x) * sx + static_cast<real>(c.y) * sy + static_cast<real>(c.z);
      const real c2 = static_cast<real>(c.x) * c.x + static_cast<real>(c.y) * c.y + static_cast<real>(c.z) * c.z;
      const real q = b * b / s2 - c2 + radius * radius;
      if (q < 0.19L * radius * radius || radius < 16) continue;
      const real half = std::sqrt(q / s2), mid = b / s2;
      const real error = std::min(std::abs(z - mid + half), std::abs(z - mid - half));
      const real bar = 5 + radius * 3 * 0x1p-23L;
      ASSERT_LE(error, bar) << to_text(p.ray) << "\n" << to_text(p.prim);
      worst_t = std::max(worst_t, error / bar);
    }
  }
  std::printf("spheres: worst %.3Lf of the bound, %.2Lf steps (%.2Lf below R = 2^20); t within %.3Lf of its bar\n", worst, worst_steps, worst_small, worst_t);
  EXPECT_GT(worst, 0.3L);
  EXPECT_GT(worst_t, 0.2L);
}

}  // namespace castray::tb
