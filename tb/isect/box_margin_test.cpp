// SPDX-License-Identifier: Apache-2.0
// Runs long.
// What a hierarchy may rely on: where the reported t of a primitive lies against its box. The
// bounds are derived in docs/number-formats.md ("The margin of a box"); the worst seen is printed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "isect/hit_unit.hpp"
#include "prim_cases.hpp"
#include "scene/box.hpp"

namespace castray::tb {
namespace {

using Real = long double;

// Where the ray is inside the box [low - pad, high + pad], as an interval of z. pad: x and y only.
struct Interval {
  Real low = -INFINITY, high = INFINITY;

  void clip(std::int64_t s, Real first, Real last) {
    if (s == 0) {
      if (first > 0 || last < 0) low = INFINITY;
      return;
    }
    const Real scale = static_cast<Real>(kOne) / s, a = first * scale, b = last * scale;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
};
Interval inside(const test_ray_t& ray, const delta3_t& low, const delta3_t& high, int pad) {
  Interval z{static_cast<Real>(low.z), static_cast<Real>(high.z)};
  z.clip(ray.sx, low.x - pad, high.x + pad);
  z.clip(ray.sy, low.y - pad, high.y + pad);
  return z;
}

// How far z lies outside; negative inside.
Real beyond(const Interval& i, Real z) { return std::max(i.low - z, z - i.high); }

Real reported_z(const result_t& hit, const test_ray_t& ray) { return std::ldexp(static_cast<Real>(hit.t), -int{TFrac}) * (ray.neg ? -1 : 1); }

hit_ray_t from_everywhere(const test_ray_t& ray, t_t tmin = -TMax - 1) {
  hit_ray_t h;
  h.norm2 = ray.norm2, h.neg = ray.neg, h.tmin = tmin;
  return h;
}

// The weights found by the exact test belong to a point of the triangle, less than 2^-BaryFrac of du + dv
// and half a last bit in z from the reported one; rounding the sheared corners moved it by at most a
// step in x and in y from the ray.
TEST(BoxMargin, OfATriangleIsAStepAndTheDividersError) {
  Rng rng(71);
  Real worst = 0, worst_padded = 0, worst_share = 0;
  for (int tested = 0; tested < 100000;) {
    PrimCase p = random_case(rng);
    cand_t cand;
    if (p.prim.kind != KindTriangle || !ray_prim(p.ray, p.prim, 0, cand)) continue;
    ++tested;
    result_t hit;
    hit_unit(cand, from_everywhere(p.ray), hit);
    const delta3_t a = corner_delta(p.prim.a, p.ray.org, p.ray.axis), b = corner_delta(p.prim.b, p.ray.org, p.ray.axis),
                   c = corner_delta(p.prim.c, p.ray.org, p.ray.axis);
    const delta3_t low = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})};
    const delta3_t high = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})};
    const Real z = reported_z(hit, p.ray);
    const Real margin = std::ldexp(Real(std::llabs(a.z - c.z) + std::llabs(b.z - c.z)), -int{BaryFrac}) + std::ldexp(Real(1), -int{TFrac} - 1);
    const Interval padded = inside(p.ray, low, high, 1);
    ASSERT_LE(padded.low, padded.high + 1e-6L) << "the ray misses the padded box\n" << to_text(p.ray) << "\n" << to_text(p.prim);
    ASSERT_LE(beyond(padded, z), margin + 1e-6L) << to_text(p.ray) << "\n" << to_text(p.prim);
    ASSERT_LE(margin + 1 - std::ldexp(Real(1), -int{TFrac}), BoxMargin);   // that of a t cut to whole steps
    if (const Interval bare = inside(p.ray, low, high, 0); bare.low <= bare.high) worst = std::max(worst, beyond(bare, z));
    worst_padded = std::max(worst_padded, beyond(padded, z));
    worst_share = std::max(worst_share, beyond(padded, z) / margin);
  }
  std::printf("triangles: t lies up to %.2Lf steps outside the bare box, %.2Lf outside the one padded by a step, %.2Lf of the margin\n",
              worst, worst_padded, worst_share);
  EXPECT_GT(worst, 8) << "the padding is needed";
  EXPECT_GT(worst_share, 0.3L) << "the margin is not idle";
}

// A sphere's box, padded on all axes, holds the reported points themselves.
TEST(BoxMargin, OfASphereIsItsPadding) {
  Rng rng(72);
  Real worst = -INFINITY, worst_share = 0;
  for (int tested = 0; tested < 100000;) {
    PrimCase p = random_case(rng);
    p.prim.kind = KindSphere;
    p.prim.b.x = random_radius(rng);
    cand_t cand;
    if (!ray_prim(p.ray, p.prim, 0, cand)) continue;
    const delta3_t c = corner_delta(p.prim.a, p.ray.org, p.ray.axis);
    const Real radius = static_cast<Real>(p.prim.b.x), padding = static_cast<Real>(sphere_padding(static_cast<std::int64_t>(p.prim.b.x)));
    result_t hit;
    t_t tmin = -TMax - 1;
    for (int root = 0; root < 2; ++root) {
      if (!hit_unit(cand, from_everywhere(p.ray, tmin), hit) || std::abs(hit.t) == TMax) break;
      tmin = hit.t;
      ++tested;
      const Real z = reported_z(hit, p.ray);
      const Real off[] = {z * p.ray.sx / kOne - c.x, z * p.ray.sy / kOne - c.y, z - c.z};
      for (const Real o : off) {
        ASSERT_LE(std::abs(o), radius + padding) << to_text(p.ray) << "\n" << to_text(p.prim);
        worst = std::max(worst, std::abs(o) - radius);
        worst_share = std::max(worst_share, (std::abs(o) - radius) / padding);
      }
    }
  }
  std::printf("spheres: a point lies up to %.2Lf steps outside the bare box, %.2Lf of the padding\n", worst, worst_share);
  EXPECT_GT(worst, 1);
}

}  // namespace
}  // namespace castray::tb
