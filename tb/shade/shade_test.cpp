// SPDX-License-Identifier: Apache-2.0
// Runs long.
// A hit's colour, from its normal to its pixel: RTL against model, model against double.
#include "shade/shade.hpp"

#include <cmath>

#include "Vshade.h"
#include "dut.hpp"
#include "stimulus.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kOne = 65536;
constexpr std::uint64_t kBaryOne = std::uint64_t{1} << BaryFrac;

paint_t two_colours(std::uint64_t scale = 2560, bool swap = false) {
  paint_t p;
  p.colour_a.r = 255, p.colour_a.g = 200, p.colour_a.b = 10;
  p.colour_b.r = 20, p.colour_b.g = 40, p.colour_b.b = 250;
  p.background.r = 1;
  p.checker_scale = scale;
  p.swap_rb = swap;
  return p;
}

class Shade : public testing::TestWithParam<Stalls> {
 protected:
  std::vector<shaded_t> run(const std::vector<shade_req_t>& requests, const point_t& eye, const paint_t& paint,
                            Stalls stalls = {}) {
    set_port(dut_->eye_i, eye);
    set_port(dut_->paint_i, paint);
    return run_stream<shaded_t>(dut_, requests, requests.size(), stalls, 7);
  }
  void compare(const std::vector<shade_req_t>& requests, const point_t& eye, const paint_t& paint, Stalls stalls = {}) {
    std::vector<shaded_t> want;
    for (const auto& r : requests) want.push_back(shade(r.hit, r.attr, eye, paint));
    expect_equal(run(requests, eye, paint, stalls), want);
  }
  std::uint64_t one(const shade_req_t& request, const point_t& eye = {}, const paint_t& paint = two_colours()) {
    const auto got = run({request}, eye, paint);
    EXPECT_EQ(got.size(), 1u);
    if (got.empty()) return 0;
    EXPECT_EQ(to_text(got[0]), to_text(shade(request.hit, request.attr, eye, paint)));
    return got[0].colour;
  }
  Dut<Vshade> dut_;
};

// A triangle of colour a whose normal is n everywhere, seen along the dominant axis.
shade_req_t facing_triangle(std::int64_t x, std::int64_t y, std::int64_t z, int axis = 2) {
  shade_req_t r;
  r.attr.na.x = r.attr.nb.x = r.attr.nc.x = x;
  r.attr.na.y = r.attr.nb.y = r.attr.nc.y = y;
  r.attr.na.z = r.attr.nb.z = r.attr.nc.z = z;
  r.attr.material = MaterialA;
  r.hit.found = 1;
  r.hit.u = kBaryOne / 3, r.hit.v = kBaryOne / 5;
  r.hit.axis = axis;
  return r;
}

TEST_P(Shade, MatchesModel) {
  Stimulus random(1);
  for (int round = 0; round < 4; ++round)
    compare(random.requests(1000), random.point(), two_colours(random.bits(18), round & 1), GetParam());
}
INSTANTIATE_TEST_SUITE_P(Stalls, Shade, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(Shade, FacingIsOneHeadOnAndZeroAtGrazing) {
  for (int axis = 0; axis < 3; ++axis)
    for (const std::int64_t sign : {1, -1}) {
      const std::int64_t n[3] = {axis == 0 ? sign * kOne : 0, axis == 1 ? sign * kOne : 0, axis == 2 ? sign * kOne : 0};
      EXPECT_EQ(one(facing_triangle(n[0], n[1], n[2], axis)), 0xff0ac8ffu) << axis;
      EXPECT_EQ(one(facing_triangle(n[1], n[2], n[0], axis)), 0xff000000u) << axis;
      EXPECT_EQ(one(facing_triangle(n[2], n[0], n[1], axis)), 0xff000000u) << axis;
    }
}

TEST_F(Shade, CancelledCornersTakeTheFaceAndZeroIsBlack) {
  shade_req_t r = facing_triangle(0, 0, 0);
  EXPECT_EQ(one(r), 0xff000000u);
  r.attr.face.z = -3;
  EXPECT_EQ(one(r), 0xff0ac8ffu);
  r = facing_triangle(0, 0, kOne);
  r.attr.nb.z = -kOne;
  r.hit.u = r.hit.v = kBaryOne / 2;
  EXPECT_EQ(one(r), 0xff000000u);  // and no face
  r.attr.face.z = 1;
  EXPECT_EQ(one(r), 0xff0ac8ffu);
}

TEST_F(Shade, SpheresFromTinyToHuge) {
  // The near and the far pole, from outside and from within, on every axis and of either sign.
  point_t eye;
  eye.x = eye.y = eye.z = 1u << 25;
  std::vector<shade_req_t> requests;
  for (const std::int64_t radius : {1, 2, 1000, 1 << 20, (1 << 25) - 1})
    for (int axis = 0; axis < 3; ++axis)
      for (const bool neg : {false, true})
        for (const std::int64_t shear : {0, 1 << 25, -(1 << 26) + 1}) {
          shade_req_t r;
          r.hit.found = 1;
          r.hit.kind = KindSphere;
          r.hit.axis = axis, r.hit.neg = neg;
          r.hit.sx = shear, r.hit.sy = -shear / 2;
          r.attr.material = MaterialChecker;
          r.attr.centre = eye;
          for (const std::int64_t depth : {radius, std::int64_t{1}}) {
            r.hit.t = depth << TFrac;
            requests.push_back(r);
          }
        }
  compare(requests, eye, two_colours());
  requests[0].attr.material = MaterialA;  // radius 1, along x: the direction is the normal
  EXPECT_EQ(one(requests[0], eye), 0xff0ac8ffu);
  requests[0].hit.t = 0;                  // the eye in the centre: a zero normal
  EXPECT_EQ(one(requests[0], eye), 0xff000000u);
}

TEST_F(Shade, EachMaterialAndPixelFormat) {
  shade_req_t r = facing_triangle(0, 0, kOne);
  r.attr.sa = r.attr.sb = r.attr.sc = kOne / 10;  // column 1 of 10, row 0
  r.attr.material = MaterialChecker;
  EXPECT_EQ(one(r), 0xff0ac8ffu);                 // a tenth, rounded down, lies in column 0
  r.attr.sa = r.attr.sb = r.attr.sc = kOne / 10 + 1;
  EXPECT_EQ(one(r), 0xfffa2814u);
  EXPECT_EQ(one(r, {}, two_colours(2560, true)), 0xff1428fau);
  r.attr.material = MaterialA;
  EXPECT_EQ(one(r), 0xff0ac8ffu);
  r.attr.material = MaterialB;
  EXPECT_EQ(one(r), 0xfffa2814u);
}

TEST_F(Shade, KeepsTheOrderOfTrianglesAndSpheres) {
  // Runs of one kind, then of the other, of every length up to 12.
  Stimulus random(5);
  std::vector<shade_req_t> requests;
  for (int length = 1; length <= 12; ++length)
    for (const std::uint64_t kind : {static_cast<std::uint64_t>(KindSphere), static_cast<std::uint64_t>(KindTriangle)})
      for (int i = 0; i < length; ++i) {
        requests.push_back(random.request());
        requests.back().hit.kind = kind;
        requests.back().hit.tag.x = requests.size();
      }
  compare(requests, random.point(), two_colours());
}

TEST_F(Shade, TakesAHitEveryTwoCycles) {
  Stimulus random(3);
  const auto requests = random.requests(600);
  const long before = dut_.cycles();
  run(requests, {}, two_colours());
  EXPECT_LE(dut_.cycles() - before, 2 * 600 + 70);
}

TEST_F(Shade, FillsWhileBlockedAndLosesNothing) {
  Stimulus random(4);
  const shade_req_t first = random.request();
  set_port(dut_->eye_i, point_t{});
  set_port(dut_->paint_i, two_colours());
  const int taken = taken_while_blocked(dut_, first);
  EXPECT_GE(taken, 9 + 16 + 4);  // paint, half of normalise, interpolate
  const auto got = run_stream<shaded_t>(dut_, std::vector<shade_req_t>{}, taken);
  expect_equal(got, std::vector<shaded_t>(taken, shade(first.hit, first.attr, {}, two_colours())));
}

TEST_F(Shade, StartsCleanAfterAReset) {
  Stimulus random(6);
  for (int cycles = 1; cycles < 90; cycles += 7) {
    taken_while_blocked(dut_, random.request(), cycles);
    dut_.reset(1);
    compare(random.requests(5), random.point(), two_colours());
  }
}

// ---- The model against double ----

struct Vec {
  double x, y, z;
};
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double facing(const Vec& a, const Vec& b) { return std::abs(dot(a, b)) / std::sqrt(dot(a, a) * dot(b, b)); }
Vec view(const hit_t& hit) {
  const double one = std::ldexp(1, ShearFrac), sx = static_cast<double>(hit.sx), sy = static_cast<double>(hit.sy);
  return hit.axis == 0 ? Vec{one, sx, sy} : hit.axis == 1 ? Vec{sy, one, sx} : Vec{sx, sy, one};
}
unit3_t quantised(Vec v) {
  const double scale = kOne / std::sqrt(dot(v, v));
  unit3_t n;
  n.x = std::llround(v.x * scale), n.y = std::llround(v.y * scale), n.z = std::llround(v.z * scale);
  return n;
}
Vec real(const unit3_t& n) { return {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)}; }

// Corner normals of unit length whose mixture is at least half as long. Weights are off by 2^-17,
// 2^-17 and 2^-16, the mixture's components by 2^-17, those of both unit vectors by 3 x 2^-16:
// (4 + 3^0.5) 2 + 2 (6 x 3^0.5) + 1 = 33.3 units of 2^-17. Measured: below 2^-12.
TEST(ShadeModel, TrianglesFaceWithinTheBound) {
  std::mt19937_64 rng(8);
  std::normal_distribution<double> normal;
  double worst = 0, worst_colour = 0;
  Stimulus random(8);
  const paint_t paint = two_colours();
  for (int i = 0; i < 200000; ++i) {
    shade_req_t r = random.request();
    r.hit.kind = KindTriangle;
    r.attr.material = MaterialA;
    const Vec base{normal(rng), normal(rng), normal(rng)};
    const double spread = std::uniform_real_distribution<double>(0, 1.5)(rng);
    const auto corner = [&] {
      return quantised({base.x + spread * normal(rng), base.y + spread * normal(rng), base.z + spread * normal(rng)});
    };
    r.attr.na = corner(), r.attr.nb = corner(), r.attr.nc = corner();
    const double u = std::ldexp(static_cast<double>(r.hit.u), -BaryFrac), v = std::ldexp(static_cast<double>(r.hit.v), -BaryFrac);
    const Vec a = real(r.attr.na), b = real(r.attr.nb), c = real(r.attr.nc);
    const auto mixed = [&](double Vec::*i) { return u * a.*i + v * b.*i + (1 - u - v) * c.*i; };
    const Vec n{mixed(&Vec::x), mixed(&Vec::y), mixed(&Vec::z)};
    if (dot(n, n) < kOne * static_cast<double>(kOne) / 4) continue;
    const double exact = facing(n, view(r.hit));
    const paint_req_t vectors = shade_vectors(r.hit, r.attr, {});
    worst = std::max(worst, std::abs(static_cast<double>(facing_of(vectors.normal, vectors.view)) / kOne - exact));
    const double red = static_cast<double>(castray::paint(vectors, paint).colour & 255);
    worst_colour = std::max(worst_colour, std::abs(red - 255 * exact));
  }
  EXPECT_LE(worst, std::ldexp(1, -12));
  EXPECT_LE(worst_colour, 0.6);
}

// The vector from the centre is off by at most a step in each component and, through the rounding
// of t, by a little more: 2 steps in all, so 2 / R, beside the unit vectors' error.
TEST(ShadeModel, SpheresFaceWithinTheBound) {
  std::mt19937_64 rng(9);
  std::normal_distribution<double> normal;
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); };
  double worst = 0;
  int tested = 0;
  for (int i = 0; i < 200000; ++i) {
    const double radius = std::exp2(uniform(0, 25));
    point_t eye, centre;
    eye.x = rng() % (1u << CoordW), eye.y = rng() % (1u << CoordW), eye.z = rng() % (1u << CoordW);
    centre.x = rng() % (1u << CoordW), centre.y = rng() % (1u << CoordW), centre.z = rng() % (1u << CoordW);
    const auto minus = [](std::uint64_t a, std::uint64_t b) { return static_cast<double>(a) - static_cast<double>(b); };
    const Vec out{normal(rng), normal(rng), normal(rng)};
    const double scale = radius / std::sqrt(dot(out, out));
    // A point of the sphere, and the ray through it, its shear rounded.
    const Vec p{minus(centre.x, eye.x) + scale * out.x, minus(centre.y, eye.y) + scale * out.y, minus(centre.z, eye.z) + scale * out.z};
    const double c[3] = {p.x, p.y, p.z};
    int axis = 0;
    for (int k = 1; k < 3; ++k) if (std::abs(c[k]) > std::abs(c[axis])) axis = k;
    const double z = c[axis], n0 = c[(axis + 1) % 3], n1 = c[(axis + 2) % 3];
    if (std::abs(z) > (1 << CoordW) - 2) continue;
    hit_t hit;
    hit.found = 1, hit.kind = KindSphere, hit.axis = axis, hit.neg = z < 0;
    const auto shear = [&](double n) { return std::clamp<std::int64_t>(std::llround(std::ldexp(n / z, ShearFrac)), -(1 << ShearFrac) + 1, (1 << ShearFrac) - 1); };
    hit.sx = shear(n0), hit.sy = shear(n1);
    hit.t = std::llround(std::ldexp(std::abs(z), TFrac));
    attr_t attr;
    attr.centre = centre;
    const double exact = facing({scale * out.x, scale * out.y, scale * out.z}, p);
    const paint_req_t vectors = shade_vectors(hit, attr, eye);
    const double got = static_cast<double>(facing_of(vectors.normal, vectors.view)) / kOne;
    worst = std::max(worst, (std::abs(got - exact) - std::ldexp(1, -12)) * radius);
    ++tested;
  }
  EXPECT_GE(tested, 100000);
  EXPECT_LE(worst, 2.0);
}

}  // namespace
}  // namespace castray::tb
