// SPDX-License-Identifier: Apache-2.0
// A triangle's normal and texture coordinates: rounding, saturation, cancelled normals.
#include "shade/interpolate.hpp"

#include "Vinterpolate.h"
#include "dut.hpp"
#include "stimulus.hpp"

namespace castray::tb {
namespace {

constexpr std::uint64_t kOne = std::uint64_t{1} << BaryFrac;

class Interpolate : public testing::TestWithParam<Stalls> {
 protected:
  std::vector<smooth_t> run(const std::vector<shade_req_t>& requests, Stalls stalls = {}, unsigned seed = 1) {
    return run_stream<smooth_t>(dut_, requests, requests.size(), stalls, seed);
  }
  smooth_t one(const shade_req_t& request) {
    const auto got = run({request});
    EXPECT_EQ(got.size(), 1u);
    if (got.empty()) return {};
    EXPECT_EQ(to_text(got[0]), to_text(interpolate(request.attr, request.hit.u, request.hit.v)));
    return got[0];
  }
  Dut<Vinterpolate> dut_;
};

shade_req_t at(std::uint64_t u, std::uint64_t v) {
  shade_req_t r;
  r.hit.u = u;
  r.hit.v = v;
  return r;
}

TEST_P(Interpolate, MatchesModel) {
  Stimulus random(1);
  const auto requests = random.requests(10000);
  std::vector<smooth_t> want;
  for (const auto& r : requests) want.push_back(interpolate(r.attr, r.hit.u, r.hit.v));
  expect_equal(run(requests, GetParam(), 3), want);
}
INSTANTIATE_TEST_SUITE_P(Stalls, Interpolate, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

// A unit vector as a mixed normal has it.
span3_t spread(const unit3_t& n) {
  span3_t out;
  out.x = n.x << kNormalKeep, out.y = n.y << kNormalKeep, out.z = n.z << kNormalKeep;
  return out;
}

TEST_F(Interpolate, GivesEachCornersOwnValues) {
  Stimulus random(2);
  for (int i = 0; i < 50; ++i) {
    shade_req_t r = random.request();
    r.attr.na.x |= 1, r.attr.nb.x |= 1, r.attr.nc.x |= 1;  // not zero
    r.hit.u = kOne, r.hit.v = 0;
    smooth_t out = one(r);
    EXPECT_TRUE(out.normal == spread(r.attr.na) && out.s == r.attr.sa && out.t == r.attr.ta);
    r.hit.u = 0, r.hit.v = kOne;
    out = one(r);
    EXPECT_TRUE(out.normal == spread(r.attr.nb) && out.s == r.attr.sb && out.t == r.attr.tb);
    r.hit.u = 0, r.hit.v = 0;
    out = one(r);
    EXPECT_TRUE(out.normal == spread(r.attr.nc) && out.s == r.attr.sc && out.t == r.attr.tc);
  }
}

TEST_F(Interpolate, RoundsTiesUp) {
  shade_req_t r = at(kOne / 2, 0);  // half of corner a, half of corner c
  r.attr.na.x = 1, r.attr.na.y = -1, r.attr.na.z = 3;
  r.attr.sa = 5, r.attr.ta = -5;
  const smooth_t out = one(r);
  EXPECT_EQ(out.normal.x, 512);  // a normal keeps ten bits more
  EXPECT_EQ(out.normal.y, -512);
  EXPECT_EQ(out.normal.z, 1536);
  EXPECT_EQ(out.s, 3);          // 2.5
  EXPECT_EQ(out.t, -2);         // -2.5
}

TEST_F(Interpolate, RoundsNormalsUpAtTheirTie) {
  shade_req_t r = at(32 << 8, 0);  // a weight of 2^-11: half of a last bit
  r.attr.na.x = 1, r.attr.na.y = -1, r.attr.na.z = 3;
  const smooth_t out = one(r);
  EXPECT_EQ(out.normal.x, 1);   // 0.5
  EXPECT_EQ(out.normal.y, 0);   // -0.5
  EXPECT_EQ(out.normal.z, 2);   // 1.5
}

TEST_F(Interpolate, RoundsWeightsUpAtTheirTie) {
  // A weight of 2^-16 moves a value of 2^26 - 1 by 1024.
  const std::int64_t big = (std::int64_t{1} << 26) - 1;
  for (const auto& [u, weight] : {std::pair{0x7fu, 0}, {0x80u, 1}, {0x17fu, 1}, {0x180u, 2}}) {
    shade_req_t r = at(u, 0);
    r.attr.sa = big;
    EXPECT_EQ(one(r).s, (weight * big + 32768) >> 16) << u;
    r = at(0, u);
    r.attr.tb = big;
    EXPECT_EQ(one(r).t, (weight * big + 32768) >> 16) << u;
  }
}

TEST_F(Interpolate, TheThirdWeightMayFallBelowZero) {
  shade_req_t r = at(kOne / 2 + 0x80, kOne / 2 - 0x80);  // 32769 and 32768 of 65536
  r.attr.sc = (1 << 26) - 1;
  EXPECT_EQ(one(r).s, (-((std::int64_t{1} << 26) - 1) + 32768) >> 16);
}

TEST_F(Interpolate, SaturatesBothWays) {
  shade_req_t r = at(kOne, kOne);  // no triangle gives this: the weight of c is -1
  const std::int64_t n = (1 << 17) - 1, s = (1 << 26) - 1;
  r.attr.na.x = r.attr.nb.x = n, r.attr.nc.x = -n - 1;
  r.attr.na.y = r.attr.nb.y = -n - 1, r.attr.nc.y = n;
  r.attr.na.z = n, r.attr.nb.z = 1, r.attr.nc.z = 0;  // one too many
  r.attr.sa = r.attr.sb = s, r.attr.sc = -s - 1;
  r.attr.ta = r.attr.tb = -s - 1, r.attr.tc = s;
  const smooth_t out = one(r);
  EXPECT_EQ(out.normal.x, (1 << 28) - 1);
  EXPECT_EQ(out.normal.y, -(1 << 28));
  EXPECT_EQ(out.normal.z, 1 << 27);  // nothing saturates
  EXPECT_EQ(out.s, s);
  EXPECT_EQ(out.t, -s - 1);
}

TEST_F(Interpolate, TakesTheFacesNormalWhereTheCornersCancel) {
  shade_req_t r = at(kOne / 2, kOne / 2);
  r.attr.na.x = 65536, r.attr.nb.x = -65536;
  r.attr.face.x = 1, r.attr.face.y = -2, r.attr.face.z = 3;
  EXPECT_TRUE(one(r).normal == spread(r.attr.face));
  // One component that does not cancel is a normal.
  for (int i = 0; i < 3; ++i) {
    shade_req_t kept = r;
    (i == 0 ? kept.attr.na.x : i == 1 ? kept.attr.na.y : kept.attr.na.z) += 2;
    EXPECT_FALSE(one(kept).normal == spread(r.attr.face)) << i;
  }
  // Half a last bit rounds to one; a little less is zero.
  r.attr.na.x = 1, r.attr.nb.x = 0;
  r.hit.u = 32 << 8;
  EXPECT_EQ(one(r).normal.x, 1);
  r.hit.u = 31 << 8;
  EXPECT_TRUE(one(r).normal == spread(r.attr.face));
  // Nothing at all: zero, which normalise passes on.
  r.attr.na = r.attr.nb = r.attr.nc = r.attr.face = unit3_t{};
  EXPECT_TRUE(one(r).normal == span3_t{});
}

TEST_F(Interpolate, TakesAHitEveryTwoCycles) {
  const auto requests = Stimulus(3).requests(500);
  const long before = dut_.cycles();
  run(requests);
  EXPECT_LE(dut_.cycles() - before, 2 * 500 + 10);
}

TEST_F(Interpolate, FillsEveryStageWhileBlocked) {
  // Seven halves behind the last one of the first hit.
  EXPECT_EQ(taken_while_blocked(dut_, at(0, 0)), 4);
}

}  // namespace
}  // namespace castray::tb
