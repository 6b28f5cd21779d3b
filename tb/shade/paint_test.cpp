// SPDX-License-Identifier: Apache-2.0
// Texture times facing ratio: ties, limits, the checker's borders, materials, pixel formats.
#include "shade/paint.hpp"

#include "Vpaint.h"
#include "dut.hpp"
#include "stimulus.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kOne = 65536;
constexpr std::uint64_t kScaleTop = (1u << 18) - 1;

rgb_t rgb(std::uint64_t r, std::uint64_t g, std::uint64_t b) {
  rgb_t colour;
  colour.r = r, colour.g = g, colour.b = b;
  return colour;
}
paint_t plain(std::uint64_t scale = 256) {
  paint_t p;
  p.colour_a = rgb(255, 128, 3);
  p.colour_b = rgb(1, 2, 254);
  p.checker_scale = scale;
  return p;
}
unit3_t unit(std::int64_t x, std::int64_t y, std::int64_t z) {
  unit3_t n;
  n.x = x, n.y = y, n.z = z;
  return n;
}
// A triangle's point at (s, t) whose facing is n . d with both along z.
paint_req_t flat(std::int64_t s, std::int64_t t, std::int64_t n = kOne, std::int64_t d = kOne) {
  paint_req_t r;
  r.s = s, r.t = t;
  r.normal = unit(0, 0, n), r.view = unit(0, 0, d);
  return r;
}

class Paint : public testing::TestWithParam<Stalls> {
 protected:
  std::vector<shaded_t> run(const std::vector<paint_req_t>& requests, const paint_t& with, Stalls stalls = {}) {
    set_port(dut_->paint_i, with);
    return run_stream<shaded_t>(dut_, requests, requests.size(), stalls, 5);
  }
  std::uint64_t one(const paint_req_t& request, const paint_t& with = plain()) {
    const auto got = run({request}, with);
    EXPECT_EQ(got.size(), 1u);
    if (got.empty()) return 0;
    EXPECT_EQ(to_text(got[0]), to_text(paint(request, with)));
    return got[0].colour;
  }
  // Does the point get colour b?
  bool is_b(const paint_req_t& request, const paint_t& with) {
    const std::uint64_t a = pixel_word(with.colour_a, with.swap_rb), b = pixel_word(with.colour_b, with.swap_rb);
    const std::uint64_t word = one(request, with);
    EXPECT_TRUE(word == a || word == b);
    return word == b;
  }
  Dut<Vpaint> dut_;
};

paint_t random_paint(Stimulus& random) {
  paint_t p;
  p.colour_a = rgb(random.bits(8), random.bits(8), random.bits(8));
  p.colour_b = rgb(random.bits(8), random.bits(8), random.bits(8));
  p.background = rgb(random.bits(8), random.bits(8), random.bits(8));
  p.checker_scale = random.bits(1) ? random.bits(18) : random.bits(12);
  p.swap_rb = random.bits(1);
  return p;
}
paint_req_t random_request(Stimulus& random) {
  paint_req_t r;
  r.tag = random.hit().tag;
  r.kind = random.bits(1);
  r.material = random.bits(2) == 0 ? random.bits(8) : random.bits(2);
  r.s = random.number(27), r.t = random.number(27);
  r.normal = random.unit(), r.view = random.unit();
  if (random.bits(1)) {  // near unit length, as from the normaliser
    const auto shrink = [](unit3_t& n) { n.x /= 3, n.y /= 3, n.z /= 3; };
    shrink(r.normal), shrink(r.view);
  }
  return r;
}

TEST_P(Paint, MatchesModel) {
  Stimulus random(1);
  for (int round = 0; round < 10; ++round) {
    const paint_t with = random_paint(random);
    std::vector<paint_req_t> requests;
    std::vector<shaded_t> want;
    for (int i = 0; i < 1000; ++i) {
      requests.push_back(random_request(random));
      want.push_back(paint(requests.back(), with));
    }
    expect_equal(run(requests, with, GetParam()), want);
  }
}
INSTANTIATE_TEST_SUITE_P(Stalls, Paint, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(Paint, RoundsColoursHalfUp) {
  EXPECT_EQ(one(flat(0, 0, kOne / 2)), 0xff000000u | 128u | 64u << 8 | 2u << 16);  // 127.5, 64, 1.5
  EXPECT_EQ(one(flat(0, 0, kOne / 2 - 1)) & 0xff, 127u);
  paint_t p = plain();
  p.colour_a = rgb(1, 1, 1);
  EXPECT_EQ(one(flat(0, 0, kOne / 2), p), 0xff010101u);
  EXPECT_EQ(one(flat(0, 0, kOne / 2 - 1), p), 0xff000000u);
}

TEST_F(Paint, FacingIsZeroAtGrazing) {
  paint_req_t r = flat(0, 0);
  r.normal = unit(kOne, 0, 0), r.view = unit(0, kOne, 0);
  EXPECT_EQ(one(r), 0xff000000u);
  r.normal = unit(0, 0, 0);  // a zero normal
  EXPECT_EQ(one(r), 0xff000000u);
}

TEST_F(Paint, FacingIsOneAtMost) {
  paint_t p = plain();
  p.colour_a = rgb(255, 254, 1);
  const std::uint64_t full = pixel_word(p.colour_a, false);
  for (const std::int64_t n : {kOne, kOne + 1, std::int64_t{131071}})
    for (const std::int64_t sign : {1, -1}) {
      EXPECT_EQ(one(flat(0, 0, sign * n), p), full) << sign * n;
      EXPECT_EQ(one(flat(0, 0, n, sign * n), p), full) << n;
    }
  paint_req_t r = flat(0, 0);
  r.normal = r.view = unit(-131072, -131072, -131072);  // the largest product of all
  EXPECT_EQ(one(r, p), full);
  r.view = unit(131071, 131071, 131071);
  EXPECT_EQ(one(r, p), full);
  EXPECT_EQ(one(flat(0, 0, kOne - 257), p) & 0xff, 254u);  // 255 (1 - 257/65536) = 254.000015
}

TEST_F(Paint, FacingRoundsBeforeItsMagnitude) {
  // Of n . d in units of 2^-16 the fraction is exactly half: upwards is towards zero for a negative
  // one. With c = 1 the colour shows on which side of 0x8000 the facing came out.
  paint_t p = plain();
  p.colour_a = rgb(1, 1, 1);
  paint_req_t r = flat(0, 0);
  r.normal = unit(kOne / 2 - 1, 1, 0);
  r.view = unit(kOne, kOne / 2, 0);  // 32767.5
  EXPECT_EQ(one(r, p) & 0xff, 1u);
  r.view = unit(-kOne, -kOne / 2, 0);  // -32767.5 is -32767
  EXPECT_EQ(one(r, p) & 0xff, 0u);
}

TEST_F(Paint, CheckerChangesAtItsBorders) {
  for (const std::uint64_t scale : {std::uint64_t{1}, std::uint64_t{256}, std::uint64_t{2560}, std::uint64_t{131072}, kScaleTop}) {
    const paint_t p = plain(scale);
    for (const std::int64_t column : {-3, -1, 0, 1, 2, 7}) {
      const std::int64_t border = column * (std::int64_t{1} << 24);
      // The first s at or beyond the border.
      const std::int64_t s = border >= 0 ? (border + static_cast<std::int64_t>(scale) - 1) / static_cast<std::int64_t>(scale)
                                         : -(-border / static_cast<std::int64_t>(scale));
      if (!fits_signed(s, 27) || !fits_signed(s - 1, 27)) continue;
      EXPECT_EQ(is_b(flat(s, 0), p), (column & 1) != 0) << scale << " column " << column;
      EXPECT_EQ(is_b(flat(s - 1, 0), p), (column & 1) == 0) << scale << " column " << column;
      EXPECT_EQ(is_b(flat(0, s), p), (column & 1) != 0) << scale << " row " << column;
      EXPECT_EQ(is_b(flat(s, s - 1), p), true) << scale << " both " << column;
    }
  }
}

TEST_F(Paint, TakesTheLargestTextureCoordinates) {
  const std::int64_t most = (1 << 26) - 1;
  for (const std::uint64_t scale : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{255}, (kScaleTop + 1) / 2, kScaleTop - 1, kScaleTop})
    for (const std::int64_t s : {most, most - 1, -most - 1, -most})
      for (const std::int64_t t : {most, -most - 1, std::int64_t{0}}) {
        const paint_t p = plain(scale);
        const auto column = [&](std::int64_t x) { return static_cast<int128>(x) * scale >> 24; };
        EXPECT_EQ(is_b(flat(s, t), p), ((column(s) ^ column(t)) & 1) != 0) << scale << " " << s << " " << t;
      }
}

TEST_F(Paint, MaterialsForceTheirColour) {
  const paint_t p = plain(256);
  for (const std::int64_t s : {std::int64_t{0}, kOne}) {  // even, odd
    paint_req_t r = flat(s, 0);
    r.material = MaterialChecker;
    EXPECT_EQ(is_b(r, p), s != 0);
    r.material = MaterialA;
    EXPECT_FALSE(is_b(r, p));
    r.material = MaterialB;
    EXPECT_TRUE(is_b(r, p));
    for (const std::uint64_t other : {3, 128, 255}) {
      r.material = other;
      EXPECT_EQ(is_b(r, p), s != 0) << other;
    }
  }
}

TEST_F(Paint, SpheresTakeTheirTextureFromTheNormal) {
  const paint_t p = plain(512);  // two columns: the border lies at n.x = 0
  const auto sphere = [](std::int64_t x, std::int64_t y) {
    paint_req_t r = flat(kOne, 0);  // s and t are not used
    r.kind = KindSphere;
    r.normal = unit(x, y, kOne), r.view = unit(0, 0, kOne);
    return r;
  };
  EXPECT_FALSE(is_b(sphere(-1, -1), p));
  EXPECT_TRUE(is_b(sphere(0, -1), p));
  EXPECT_TRUE(is_b(sphere(-1, 0), p));
  EXPECT_FALSE(is_b(sphere(0, 0), p));
  EXPECT_FALSE(is_b(sphere(-kOne, -1), p));
  EXPECT_TRUE(is_b(sphere(-kOne - 1, -1), p));  // one unit too long: s below zero
  EXPECT_FALSE(is_b(sphere(kOne, -1), p));      // s is exactly one
  EXPECT_TRUE(is_b(sphere(kOne - 1, -1), p));   // halves are dropped: s is just below one
}

TEST_F(Paint, SwapsRedAndBlueForBgra) {
  paint_t p = plain();
  EXPECT_EQ(one(flat(0, 0), p), 0xff0380ffu);
  p.swap_rb = 1;
  EXPECT_EQ(one(flat(0, 0), p), 0xffff8003u);
}

TEST_F(Paint, TakesOneACycle) {
  const std::vector<paint_req_t> requests(500, flat(0, 0));
  const long before = dut_.cycles();
  run(requests, plain());
  EXPECT_LE(dut_.cycles() - before, 500 + 10);
}

TEST_F(Paint, FillsEveryStageWhileBlocked) { EXPECT_EQ(taken_while_blocked(dut_, flat(0, 0)), 9); }

// Against exact arithmetic on the same vectors: facing within half a unit, colours within half of
// 255ths and what half a unit of facing moves.
TEST_F(Paint, ModelIsExactToItsRounding) {
  Stimulus random(4);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    paint_req_t r = random_request(random);
    r.material = MaterialA;
    const paint_t p = random_paint(random);
    const double dot = (static_cast<double>(r.normal.x) * r.view.x + static_cast<double>(r.normal.y) * r.view.y +
                        static_cast<double>(r.normal.z) * r.view.z) / kOne / kOne;
    const double colour = static_cast<double>(p.colour_a.g) * std::min(std::abs(dot), 1.0);
    worst = std::max(worst, std::abs(colour - static_cast<double>(paint(r, p).colour >> 8 & 255)));
  }
  EXPECT_LE(worst, 0.5 + 255.0 / 2 / kOne + 1e-9);
}

}  // namespace
}  // namespace castray::tb
