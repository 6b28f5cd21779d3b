// SPDX-License-Identifier: Apache-2.0
// Edge functions: exact, the sign of every zero, a sphere's sums of products on the same multipliers.
#include "Vedge_fns.h"
#include "chain_run.hpp"
#include "isect/edge_fns.hpp"
#include "prim_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

struct Sheared {
  sheared2_t a, b, c;
};

class EdgeFns : public testing::TestWithParam<Stalls> {
 protected:
  void corners(const Sheared& t) {
    set_signed(dut_->ax_i, t.a.x, sheared_t_bits), set_signed(dut_->ay_i, t.a.y, sheared_t_bits);
    set_signed(dut_->bx_i, t.b.x, sheared_t_bits), set_signed(dut_->by_i, t.b.y, sheared_t_bits);
    set_signed(dut_->cx_i, t.c.x, sheared_t_bits), set_signed(dut_->cy_i, t.c.y, sheared_t_bits);
  }
  // Four stages. The result of the last triangle is the answer.
  edge_fns_t run(const std::vector<Sheared>& triangles, Stalls stalls = {}) {
    dut_->sphere_i = dut_->sums_i = 0;
    edge_fns_t got;
    run_chain(
        dut_, 4, triangles.size(), stalls, [&](std::size_t i) { corners(triangles[i]); },
        [&](unsigned load) { dut_->en_i = load; },
        [&](std::size_t i) {
          // What comes is less one unless its zero would be positive; its sign is the function's.
          got.u = get_signed(dut_->u_o, mul_sum_t_bits), got.u_neg = got.u < 0, got.u += !dut_->u_up_o;
          got.v = get_signed(dut_->v_o, mul_sum_t_bits), got.v_neg = got.v < 0, got.v += !dut_->v_up_o;
          got.w = get_signed(dut_->w_o, mul_sum_t_bits), got.w_neg = got.w < 0, got.w += !dut_->w_up_o;
          got.point = dut_->point_o;
          const Sheared& t = triangles[i];
          const edge_fns_t want = edge_fns(t.a, t.b, t.c);
          ASSERT_TRUE(got.u == want.u && got.v == want.v && got.w == want.w) << "triangle " << i;
          ASSERT_TRUE(got.u_neg == want.u_neg && got.v_neg == want.v_neg && got.w_neg == want.w_neg) << "triangle " << i;
          ASSERT_EQ(got.point, want.point) << "triangle " << i;
        });
    return got;
  }
  Dut<Vedge_fns> dut_;
};

TEST_F(EdgeFns, AreTheSignedAreas) {
  const edge_fns_t e = run({{{1, 2}, {30, 5}, {7, 11}}});
  EXPECT_EQ(e.u, 7 * 5 - 11 * 30);
  EXPECT_EQ(e.v, 1 * 11 - 2 * 7);
  EXPECT_EQ(e.w, 30 * 2 - 5 * 1);
  EXPECT_TRUE(e.u_neg && e.v_neg);
  EXPECT_FALSE(e.w_neg || e.point);
}

TEST_F(EdgeFns, ZeroTakesItsSignFromTheHeights) {
  // The ray lies on the edge from B to C: U is zero, positive where C is the higher.
  for (const int up : {1, -1}) {
    const edge_fns_t e = run({{{30, 0}, {0, -10 * up}, {0, 10 * up}}});
    EXPECT_EQ(e.u, 0);
    EXPECT_EQ(e.u_neg, up < 0);
    EXPECT_FALSE(e.point);
  }
}

TEST_F(EdgeFns, AtEqualHeightsTheLowerXIsAbove) {
  for (const int left : {1, -1}) {  // C is left of B, or right of it
    const edge_fns_t e = run({{{0, 30}, {10 * left, 0}, {-10 * left, 0}}});
    EXPECT_EQ(e.u, 0);
    EXPECT_EQ(e.u_neg, left < 0);
  }
}

TEST_F(EdgeFns, APointIsWhereAllThreeCoincide) {
  for (const sheared2_t p : {sheared2_t{0, 0}, sheared2_t{5, -7}, sheared2_t{-(1 << CoordW), (1 << CoordW) - 1}}) {
    EXPECT_TRUE(run({{p, p, p}}).point);
    EXPECT_FALSE(run({{p, p, {p.x + 1, p.y}}}).point);
    EXPECT_FALSE(run({{{p.x, p.y - 1}, p, p}}).point);
  }
}

TEST_F(EdgeFns, DecidesEveryTieOfASmallLattice) {
  std::vector<Sheared> triangles;
  const auto at = [](int i) { return sheared2_t{i % 3 - 1, i / 3 - 1}; };
  for (int i = 0; i < 9 * 9 * 9; ++i) triangles.push_back({at(i % 9), at(i / 9 % 9), at(i / 81)});
  run(triangles);
}

TEST_F(EdgeFns, ReachesEveryExtreme) {
  const std::int64_t ends[3] = {-(1 << CoordW), (1 << CoordW) - 1, 0};
  std::vector<Sheared> triangles;
  for (int i = 0; i < 729; ++i)
    triangles.push_back({{ends[i % 3], ends[i / 3 % 3]}, {ends[i / 9 % 3], ends[i / 27 % 3]}, {ends[i / 81 % 3], ends[i / 243]}});
  run(triangles);
}

TEST_P(EdgeFns, MatchesModel) {
  Rng rng(3);
  std::vector<Sheared> triangles(20000);
  for (Sheared& t : triangles) {
    const std::int64_t reach = std::int64_t{1} << rng.in(1, CoordW);
    for (sheared2_t* p : {&t.a, &t.b, &t.c}) *p = {rng.in(-reach, reach - 1), rng.in(-reach, reach - 1)};
    if (rng.chance(8)) t.b = t.a;
    if (rng.chance(8)) t.c.y = t.b.y;
  }
  run(triangles, GetParam());
}

// X Sx + Y Sy, X Sy - Y Sx, X^2 + Y^2, four stages on; the second a cycle earlier too.
TEST_P(EdgeFns, AddsProductsForASphere) {
  struct Sphere {
    std::int64_t x, y, sx, sy;
  };
  Rng rng(4);
  std::vector<Sphere> spheres;
  const auto sheared = [&] { return rng.chance(4) ? -(std::int64_t{1} << CoordW) : rng.in(-(1 << CoordW), (1 << CoordW) - 1); };
  for (int i = 0; i < 5000; ++i) spheres.push_back({sheared(), sheared(), rng.shear(), rng.shear()});
  dut_->sums_i = 1;
  run_chain(
      dut_, 4, spheres.size(), GetParam(),
      [&](std::size_t i) {
        const Sphere& s = spheres[i];
        corners({{s.x, s.y}, {rng.in(-9, 9), rng.in(-9, 9)}, {rng.in(-9, 9), rng.in(-9, 9)}});  // only A is read
        set_signed(dut_->sx_i, s.sx, shear_t_bits), set_signed(dut_->sy_i, s.sy, shear_t_bits);
        dut_->sphere_i = 1;
      },
      [&](unsigned load) { dut_->en_i = load; },
      [&](std::size_t i) {
        const Sphere& s = spheres[i];
        ASSERT_EQ(get_signed(dut_->u_o, mul_sum_t_bits), s.x * s.sx + s.y * s.sy);
        ASSERT_EQ(get_signed(dut_->v_o, mul_sum_t_bits), s.x * s.sy - s.y * s.sx);
        ASSERT_EQ(get_signed(dut_->w_o, mul_sum_t_bits), s.x * s.x + s.y * s.y);
      });
}

INSTANTIATE_TEST_SUITE_P(Stalls, EdgeFns, testing::ValuesIn(kStallPatterns), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace castray::tb
