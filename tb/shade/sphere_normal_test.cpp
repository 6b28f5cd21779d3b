// SPDX-License-Identifier: Apache-2.0
// From a sphere's centre to the hit: axes, signs, rounding, extremes.
#include "shade/sphere_normal.hpp"

#include <cmath>

#include "Vsphere_normal.h"
#include "dut.hpp"
#include "stimulus.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kSteps = 1 << TFrac;
constexpr std::uint64_t kFar = (1u << CoordW) - 1;

class SphereNormal : public testing::TestWithParam<Stalls> {
 protected:
  std::vector<span3_t> run(const std::vector<shade_req_t>& requests, const point_t& eye, Stalls stalls = {}) {
    set_port(dut_->eye_i, eye);
    return run_stream<span3_t>(dut_, requests, requests.size(), stalls, 5);
  }
  span3_t one(const shade_req_t& request, const point_t& eye = {}) {
    const auto got = run({request}, eye);
    EXPECT_EQ(got.size(), 1u);
    if (got.empty()) return {};
    EXPECT_EQ(to_text(got[0]), to_text(sphere_normal(request.hit, request.attr.centre, eye)));
    return got[0];
  }
  Dut<Vsphere_normal> dut_;
};

shade_req_t ray(int axis, std::int64_t sx, std::int64_t sy, std::int64_t t, bool neg) {
  shade_req_t r;
  r.hit.kind = KindSphere;
  r.hit.axis = axis;
  r.hit.sx = sx;
  r.hit.sy = sy;
  r.hit.t = t;
  r.hit.neg = neg;
  return r;
}
span3_t vec(std::int64_t x, std::int64_t y, std::int64_t z) {
  span3_t v;
  v.x = x, v.y = y, v.z = z;
  return v;
}

TEST_P(SphereNormal, MatchesModel) {
  Stimulus random(1);
  for (int round = 0; round < 4; ++round) {
    const point_t eye = random.point();
    const auto requests = random.requests(2500);
    std::vector<span3_t> want;
    for (const auto& r : requests) want.push_back(sphere_normal(r.hit, r.attr.centre, eye));
    expect_equal(run(requests, eye, GetParam()), want);
  }
}
INSTANTIATE_TEST_SUITE_P(Stalls, SphereNormal, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(SphereNormal, FollowsEveryAxisAndSign) {
  const std::int64_t half = std::int64_t{1} << (ShearFrac - 1), quarter = half / 2;
  for (const int sign : {1, -1}) {
    const std::int64_t t = 1000 * kSteps, z = sign * 1000;
    const bool neg = sign < 0;
    EXPECT_TRUE(one(ray(0, half, -quarter, t, neg)) == vec(z, z / 2, -z / 4));  // x from (y, z, x)
    EXPECT_TRUE(one(ray(1, half, -quarter, t, neg)) == vec(-z / 4, z, z / 2));  // y from (z, x, y)
    EXPECT_TRUE(one(ray(2, half, -quarter, t, neg)) == vec(z / 2, -z / 4, z));
  }
}

TEST_F(SphereNormal, RoundsDepthHalfUp) {
  for (const auto& [t, z] : {std::pair{7, 0}, {8, 1}, {23, 1}, {24, 2}, {-8, 0}, {-9, -1}, {-24, -1}, {-25, -2}}) {
    EXPECT_EQ(one(ray(2, 0, 0, t, false)).z, z) << t;
    EXPECT_EQ(one(ray(2, 0, 0, -t, true)).z, z) << t;
  }
}

TEST_F(SphereNormal, RoundsOffsetsHalfUp) {
  const std::int64_t half = std::int64_t{1} << (ShearFrac - 1);
  EXPECT_TRUE(one(ray(2, half, -half, 3 * kSteps, false)) == vec(2, -1, 3));   // 1.5, -1.5
  EXPECT_TRUE(one(ray(2, half - 1, -half - 1, 3 * kSteps, false)) == vec(1, -2, 3));
}

TEST_F(SphereNormal, SaturatesDepth) {
  // The largest distances, which no scene holds; the lowest one twice negated.
  const std::int64_t most = (std::int64_t{1} << CoordW) - 1, s = (std::int64_t{1} << ShearFrac) - 1;
  EXPECT_EQ(one(ray(2, s, -s, TMax, false)).z, most);
  EXPECT_EQ(one(ray(2, s, -s, TMax, true)).z, -most - 1);
  EXPECT_EQ(one(ray(2, s, -s, -TMax - 1, false)).z, -most - 1);
  EXPECT_EQ(one(ray(2, s, -s, -TMax - 1, true)).z, most);
}

TEST_F(SphereNormal, HoldsTheWidestVector) {
  const std::int64_t s = (std::int64_t{1} << ShearFrac) - 1;
  point_t low, high;
  high.x = high.y = high.z = kFar;
  for (const bool neg : {false, true}) {
    for (const bool swapped : {false, true}) {
      shade_req_t r = ray(1, s, -s, TMax, neg);
      r.attr.centre = swapped ? high : low;
      one(r, swapped ? low : high);
    }
  }
}

// Within one step of the exact vector, whatever the size of the sphere.
TEST_F(SphereNormal, ModelIsWithinAStep) {
  Stimulus random(9);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    hit_t hit = random.hit();
    if (hit.t == -TMax - 1) continue;
    const point_t eye = random.point(), centre = random.point();
    const span3_t v = sphere_normal(hit, centre, eye);
    const double z = std::ldexp(static_cast<double>(hit.neg ? -hit.t : hit.t), -TFrac);
    if (std::abs(z) > kFar) continue;
    const double p[3] = {std::ldexp(static_cast<double>(hit.sx), -ShearFrac) * z, std::ldexp(static_cast<double>(hit.sy), -ShearFrac) * z, z};
    const int first = hit.axis == 0 ? 1 : hit.axis == 1 ? 2 : 0;  // the scene's axis of Sx
    const std::int64_t got[3] = {v.x, v.y, v.z};
    const double from[3] = {static_cast<double>(eye.x) - static_cast<double>(centre.x),
                            static_cast<double>(eye.y) - static_cast<double>(centre.y),
                            static_cast<double>(eye.z) - static_cast<double>(centre.z)};
    for (int k = 0; k < 3; ++k) {
      const int axis = (first + k) % 3;
      worst = std::max(worst, std::abs(static_cast<double>(got[axis]) - (from[axis] + p[k])));
    }
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GE(worst, 0.9);
}

TEST_F(SphereNormal, TakesAHitEveryTwoCycles) {
  const auto requests = Stimulus(3).requests(500);
  const long before = dut_.cycles();
  run(requests, {});
  EXPECT_LE(dut_.cycles() - before, 2 * 500 + 10);
}

TEST_F(SphereNormal, FillsEveryStageWhileBlocked) {
  // One in the output register, its follower's second half behind it, five halves after that.
  EXPECT_EQ(taken_while_blocked(dut_, ray(0, 0, 0, 0, false)), 4);
}

}  // namespace
}  // namespace castray::tb
