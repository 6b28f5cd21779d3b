// SPDX-License-Identifier: Apache-2.0
// Acceptance: every combination of signs, culling from either side, magnitudes at every extreme.
#include "isect/accept.hpp"

#include <cstdlib>

#include "Vaccept.h"
#include "dut.hpp"
#include "prim_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

struct Case {
  edge_fns_t e;
  bool neg = false, cull = false;
};

class Accept : public testing::TestWithParam<Stalls> {
 protected:
  static constexpr int kStages = 2;
  // Sends the cases through; each that the model accepts comes out two cycles on, nothing else does.
  // How many were accepted.
  int run(const std::vector<Case>& cases, Stalls stalls = {}) {
    Gate source(stalls.source, stalls.burst, 1);
    Rng rng(2);
    const Case* inside[kStages] = {};  // what entered one cycle ago, two cycles ago
    int accepted = 0;
    for (std::size_t next = 0; next < cases.size() || inside[0] || inside[1];) {
      const bool offer = next < cases.size() && source.open();
      set(cases[offer ? next : static_cast<std::size_t>(rng.in(0, static_cast<std::int64_t>(cases.size()) - 1))]);
      dut_->valid_i = offer;
      dut_.tick();
      inside[1] = inside[0];
      inside[0] = offer ? &cases[next++] : nullptr;
      accepted += check(inside[1]);
      if (HasFailure()) break;
    }
    dut_->valid_i = 0;
    return accepted;
  }
  bool accepts(const Case& c) { return run({c}) == 1; }
  area_t u_o() const { return u_; }
  Dut<Vaccept> dut_;

 private:
  void set(const Case& c) {
    dut_->neg_i = c.neg, dut_->cull_i = c.cull, dut_->point_i = c.e.point;
    const bool u_up = up(c.e.u, c.e.u_neg), v_up = up(c.e.v, c.e.v_neg), w_up = up(c.e.w, c.e.w_neg);
    set_signed(dut_->u_i, c.e.u - !u_up, edge_fn_t_bits), dut_->u_up_i = u_up;
    set_signed(dut_->v_i, c.e.v - !v_up, edge_fn_t_bits), dut_->v_up_i = v_up;
    set_signed(dut_->w_i, c.e.w - !w_up, edge_fn_t_bits), dut_->w_up_i = w_up;
  }
  // A zero's up is its sign, another's is either.
  static bool up(std::int64_t x, bool negative) { return x == 0 ? !negative : x % 2 == 0; }
  bool check(const Case* c) {
    const bool want = c && accept(c->e, c->neg, c->cull);
    EXPECT_EQ(bool(dut_->valid_o), want);
    if (!want) return false;
    u_ = dut_->u_o;
    EXPECT_EQ(dut_->u_o, static_cast<std::uint64_t>(std::llabs(c->e.u)));
    EXPECT_EQ(dut_->v_o, static_cast<std::uint64_t>(std::llabs(c->e.v)));
    EXPECT_EQ(dut_->det_o, static_cast<std::uint64_t>(std::llabs(c->e.u + c->e.v + c->e.w)));
    return true;
  }
  area_t u_ = 0;
};

// A triangle whose edge functions have these values; a zero's sign is that of the first.
Case with(std::int64_t u, std::int64_t v, std::int64_t w, bool neg = false, bool cull = false) {
  Case c;
  c.e.u = u, c.e.v = v, c.e.w = w;
  c.e.u_neg = u < 0, c.e.v_neg = v < 0 || (v == 0 && u < 0), c.e.w_neg = w < 0 || (w == 0 && u < 0);
  c.neg = neg, c.cull = cull;
  return c;
}

TEST_F(Accept, OnlyWhereAllThreeSignsAreEqual) {
  for (int signs = 0; signs < 8; ++signs) {
    const Case c = with(signs & 1 ? -3 : 3, signs & 2 ? -5 : 5, signs & 4 ? -7 : 7);
    EXPECT_EQ(accepts(c), signs == 0 || signs == 7) << signs;
  }
}

TEST_F(Accept, TheSignOfAZeroCounts) {
  Case c = with(0, 0, 9);
  EXPECT_TRUE(accepts(c));
  c.e.u_neg = true;
  EXPECT_FALSE(accepts(c));
  c = with(-4, 0, 0);
  EXPECT_TRUE(accepts(c));
  EXPECT_EQ(u_o(), 4u);
  c.e.w_neg = false;
  EXPECT_FALSE(accepts(c));
}

TEST_F(Accept, NotAPoint) {
  Case c = with(0, 0, 0);
  c.e.point = true;
  EXPECT_FALSE(accepts(c));
  c.e.u_neg = c.e.v_neg = c.e.w_neg = true;
  EXPECT_FALSE(accepts(c));
}

TEST_F(Accept, CullsTheSideThatLooksAway) {
  for (const bool neg : {false, true}) {
    EXPECT_EQ(accepts(with(1, 2, 3, neg, true)), !neg);
    EXPECT_EQ(accepts(with(-1, -2, -3, neg, true)), neg);
    EXPECT_TRUE(accepts(with(1, 2, 3, neg)));
    EXPECT_TRUE(accepts(with(-1, -2, -3, neg)));
  }
}

TEST_F(Accept, AddsTheLargestAreas) {
  const std::int64_t end = std::int64_t{1} << (2 * CoordW + 2);  // the most negative edge function
  EXPECT_EQ(run({with(-end, -end, -end), with(end - 1, end - 1, end - 1), with(-end, 0, -1)}), 3);
}

TEST_F(Accept, KeepsAResultUntilTheNextOne) {
  EXPECT_TRUE(accepts(with(11, 12, 13)));
  EXPECT_FALSE(accepts(with(-1, 2, 3)));
  EXPECT_EQ(dut_->u_o, 11u);
  EXPECT_EQ(dut_->det_o, 36u);
}

TEST_F(Accept, ResetEmptiesIt) {
  dut_->u_i = dut_->v_i = dut_->w_i = 1;
  dut_->u_up_i = dut_->v_up_i = dut_->w_up_i = 1;
  dut_->point_i = dut_->cull_i = 0;
  dut_->valid_i = 1;
  for (int i = 0; i < kStages; ++i) dut_.tick();
  EXPECT_TRUE(dut_->valid_o);
  dut_->valid_i = 0;
  dut_.reset(1);
  for (int i = 0; i < kStages; ++i, dut_.tick()) EXPECT_FALSE(dut_->valid_o);
}

TEST_P(Accept, MatchesModel) {
  Rng rng(5);
  std::vector<Case> cases(20000);
  for (Case& c : cases) {
    const std::int64_t reach = (std::int64_t{1} << rng.in(0, 2 * CoordW + 2)) - 1;
    const bool alike = rng.chance(2);
    c = with(rng.in(-reach, reach), rng.in(-reach, reach), rng.in(-reach, reach), rng.chance(2), rng.chance(2));
    if (alike) c = with(c.e.u, std::llabs(c.e.v) * (c.e.u < 0 ? -1 : 1), std::llabs(c.e.w) * (c.e.u < 0 ? -1 : 1), c.neg, c.cull);
    c.e.point = rng.chance(10);
  }
  EXPECT_GT(run(cases, GetParam()), 5000);
}
INSTANTIATE_TEST_SUITE_P(Stalls, Accept, testing::ValuesIn(kStallPatterns), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace castray::tb
