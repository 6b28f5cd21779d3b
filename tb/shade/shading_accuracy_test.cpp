// SPDX-License-Identifier: Apache-2.0
// How far the model's facing ratio and colour may lie from exact ones: the bounds of
// docs/number-formats.md, asserted for each sample; the largest errors seen are printed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "isect/hit_unit.hpp"
#include "isect/ray_prim.hpp"
#include "shade/shade.hpp"

namespace castray::tb {
namespace {

using Real = long double;
constexpr Real kUlp = 1.0L / (1 << UnitFrac);  // last bit of a normal or a facing ratio
constexpr std::int64_t kShearOne = std::int64_t{1} << ShearFrac;

struct Vector {
  Real x, y, z;
  Real length() const { return std::sqrt(x * x + y * y + z * z); }
};
Real cosine(const Vector& a, const Vector& b) {
  return std::abs(a.x * b.x + a.y * b.y + a.z * b.z) / (a.length() * b.length());
}

class ShadingAccuracy : public ::testing::Test {
 protected:
  std::int64_t in(std::int64_t low, std::int64_t high) { return std::uniform_int_distribution<std::int64_t>(low, high)(rng_); }
  unit3_t normal() {
    std::normal_distribution<double> gauss;
    const Vector v = {gauss(rng_), gauss(rng_), gauss(rng_)};
    const auto fixed = [&](Real x) { return std::llround(x / v.length() / kUlp); };
    return {.z = fixed(v.z), .y = fixed(v.y), .x = fixed(v.x)};
  }
  hit_t random_ray() {
    hit_t hit;
    hit.sx = in(1 - kShearOne, kShearOne - 1);
    hit.sy = in(1 - kShearOne, kShearOne - 1);
    hit.axis = static_cast<axis_t>(in(0, 2));
    hit.neg = static_cast<std::uint64_t>(in(0, 1));
    return hit;
  }
  static Vector view(const hit_t& hit) {
    const delta3_t d = unpermute({hit.sx, hit.sy, kShearOne}, hit.axis);
    return {static_cast<Real>(d.x), static_cast<Real>(d.y), static_cast<Real>(d.z)};
  }
  static std::int64_t facing(const paint_req_t& req) { return facing_of(req.normal, req.view); }

  std::mt19937_64 rng_{81};
};

// The interpolated normal is off by 2.5 last bits in each component; each unit vector by 1.75 last
// bits, the view by its truncation of less than 1.42 more; the product is rounded.
TEST_F(ShadingAccuracy, OfTriangles) {
  Real worst = 0, worst_colour = 0;
  long beyond = 0;
  for (int i = 0; i < 200000; ++i) {
    hit_t hit = random_ray();
    hit.kind = KindTriangle;
    hit.u = static_cast<bary_t>(in(0, 1 << BaryFrac));
    hit.v = static_cast<bary_t>(in(0, (1 << BaryFrac) - static_cast<std::int64_t>(hit.u)));
    attr_t attr;
    attr.na = normal(), attr.nb = normal(), attr.nc = normal(), attr.face = normal();
    const Real u = std::ldexp(static_cast<Real>(hit.u), -BaryFrac), v = std::ldexp(static_cast<Real>(hit.v), -BaryFrac), w = 1 - u - v;
    const Vector n = {(u * attr.na.x + v * attr.nb.x + w * attr.nc.x) * kUlp, (u * attr.na.y + v * attr.nb.y + w * attr.nc.y) * kUlp,
                      (u * attr.na.z + v * attr.nb.z + w * attr.nc.z) * kUlp};
    if (n.length() < 1.0L / 16) continue;
    const Real exact = cosine(n, view(hit));
    const Real error = std::abs(static_cast<Real>(facing(shade_vectors(hit, attr, {}))) * kUlp - exact);
    const Real bound = kUlp * (2.5L * std::sqrt(3.0L) / n.length() + 1.75L + 1.75L + 1.42L + 0.5L);
    beyond += error > bound;
    worst = std::max(worst, error / bound);

    const std::uint64_t c = static_cast<std::uint64_t>(in(0, 255));
    paint_t paint;
    paint.colour_a = {.r = c, .g = c, .b = c};
    attr.material = MaterialA;
    const Real colour = static_cast<Real>(shade(hit, attr, {}, paint).colour & 255);
    const Real colour_error = std::abs(colour - static_cast<Real>(c) * exact);
    beyond += colour_error > 0.5L + 255 * bound;
    worst_colour = std::max(worst_colour, colour_error);
  }
  std::printf("triangles: facing within %.3Lf of its bound, colour within %.3Lf of the exact one\n", worst, worst_colour);
  EXPECT_EQ(beyond, 0);
  EXPECT_GT(worst, 0.2L);
  EXPECT_LT(worst_colour, 1);
}

// The line's distance from the centre is off by a few steps, so cos^2 by some 8 / R.
TEST_F(ShadingAccuracy, OfSpheresAwayFromTheirSilhouette) {
  Real worst = 0, worst_bits = 0;
  long beyond = 0;
  int tested = 0;
  while (tested < 100000) {
    hit_t hit = random_ray();
    const std::int64_t radius = in(1 << 12, std::int64_t{1} << in(13, 24)), depth = (hit.neg ? -1 : 1) * in(radius, 1 << 25);
    const point_t eye = {.z = 1 << 25, .y = 1 << 25, .x = 1 << 25};
    const delta3_t along = unpermute({(hit.sx * depth >> ShearFrac) + in(-radius, radius), (hit.sy * depth >> ShearFrac) + in(-radius, radius), depth}, hit.axis);
    prim_slot_t slot;
    slot.kind = KindSphere;
    slot.number = 0;
    slot.a = {.z = eye.z + static_cast<std::uint64_t>(along.z), .y = eye.y + static_cast<std::uint64_t>(along.y), .x = eye.x + static_cast<std::uint64_t>(along.x)};
    slot.b.x = static_cast<std::uint64_t>(radius);
    if ((slot.a.x | slot.a.y | slot.a.z) >> CoordW) continue;

    test_ray_t ray;
    ray.org = permuted(eye, hit.axis), ray.sx = hit.sx, ray.sy = hit.sy, ray.axis = hit.axis, ray.neg = hit.neg;
    ray.norm2 = static_cast<norm2_t>(round_shift(kShearOne * kShearOne + hit.sx * hit.sx + hit.sy * hit.sy, 2 * ShearFrac - NormFrac));
    cand_t cand;
    result_t result;
    hit_ray_t hit_ray;
    hit_ray.norm2 = ray.norm2, hit_ray.neg = ray.neg;
    if (!ray_prim(ray, slot, 0, cand) || !hit_unit(cand, hit_ray, result)) continue;
    hit.kind = KindSphere;
    hit.t = result.t;

    // cos^2 = 1 - (distance of the line from the centre / R)^2
    const Vector d = view(hit);
    const Vector c = {static_cast<Real>(along.x), static_cast<Real>(along.y), static_cast<Real>(along.z)};
    const Vector cross = {c.y * d.z - c.z * d.y, c.z * d.x - c.x * d.z, c.x * d.y - c.y * d.x};
    const Real offset = cross.length() / d.length() / radius;
    if (offset * offset > 1 - 1.0L / 256) continue;  // cos below 1/16
    ++tested;
    const Real exact = std::sqrt(1 - offset * offset);
    attr_t attr;
    attr.centre = slot.a;
    const Real error = std::abs(static_cast<Real>(facing(shade_vectors(hit, attr, eye))) * kUlp - exact);
    const Real bound = kUlp * 8 + 8 / (exact * radius);
    beyond += error > bound;
    worst = std::max(worst, error / bound);
    if (radius >= 1 << 20) worst_bits = std::max(worst_bits, error / kUlp);
  }
  std::printf("spheres: facing within %.3Lf of its bound, %.2Lf last bits for R of 2^20 steps and more\n", worst, worst_bits);
  EXPECT_EQ(beyond, 0);
  EXPECT_GT(worst, 0.2L);
}

}  // namespace
}  // namespace castray::tb
