// SPDX-License-Identifier: Apache-2.0
// The nearest hit: the smallest (distance, number) of a ray's results, in whatever order they come.
#include "traverse/nearest.hpp"

#include "Vnearest.h"
#include "dut.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 32;

class NearestUnit : public testing::Test {
 protected:
  void start(int ctx, t_t tmax) {
    dut_->start_i = 1;
    dut_->start_ctx_i = ctx;
    dut_->tmax_i = tmax;
    dut_->result_valid_i = 0;
    dut_.tick();
    dut_->start_i = 0;
  }
  void offer(const result_t& result) {
    dut_->result_valid_i = 1;
    set_port(dut_->result_i, result);
    dut_.tick();
    dut_->result_valid_i = 0;
  }
  void expect(int ctx, const Nearest& model) {
    dut_->out_ctx_i = ctx;
    dut_->node_ctx_i = ctx;
    dut_->step_ctx_i[0] = kContexts - 1, dut_->step_ctx_i[ctx % 2] = ctx;
    dut_.settle();
    const t_t t = model.best().t;
    EXPECT_EQ(get_signed(dut_->node_t_o, t_t_bits), t);
    EXPECT_EQ(dut_->step_reach_o[ctx % 2], t < 0 ? 0 : t / (1 << (CoordW + TFrac - DistW)));
    EXPECT_EQ(dut_->step_found_o >> ctx % 2 & 1, model.found());
    ASSERT_EQ(dut_->out_found_o, model.found());
    dut_.tick();  // u and v come a cycle later
    result_t expected = model.best();
    expected.ctx = static_cast<ctx_t>(ctx);
    EXPECT_EQ(to_text(get_port<result_t>(dut_->out_o)), to_text(expected));
  }
  Dut<Vnearest> dut_;
};

result_t result(int ctx, t_t t, prim_t number) {
  result_t r;
  r.ctx = ctx;
  r.t = t;
  r.number = number;
  r.u = number * 3 % 1000;
  r.v = number * 7 % 1000;
  r.kind = number & 1;
  return r;
}

TEST_F(NearestUnit, TieGoesToTheLowerNumberInEitherOrder) {
  for (const bool low_first : {true, false}) {
    start(5, TMax);
    Nearest model(TMax);
    for (const prim_t number : {low_first ? 10u : 11u, low_first ? 11u : 10u}) {
      offer(result(5, 1000, number));
      model.offer(result(5, 1000, number));
    }
    EXPECT_EQ(model.best().number, 10u);
    expect(5, model);
  }
}

TEST_F(NearestUnit, AHitAtTmaxIsNone) {
  start(0, 500);
  offer(result(0, 500, 0));
  expect(0, Nearest(500));
  offer(result(0, 499, 9));
  Nearest model(500);
  model.offer(result(0, 499, 9));
  expect(0, model);
}

TEST_F(NearestUnit, AMissHoldsNothingOfTheRayBefore) {
  start(3, TMax);
  offer(result(3, 1000, 77));
  start(3, TMax);
  expect(3, Nearest(TMax));
}

TEST_F(NearestUnit, NegativeDistancesAreNearer) {
  start(1, TMax);
  Nearest model(TMax);
  for (const t_t t : {t_t{5}, t_t{-3}, t_t{-TMax - 1}, t_t{0}}) {
    offer(result(1, t, 4));
    model.offer(result(1, t, 4));
  }
  EXPECT_EQ(model.best().t, -TMax - 1);
  expect(1, model);
}

TEST_F(NearestUnit, ReachesToTheUpperBitsOfTheDistance) {
  start(2, TMax);
  Nearest model(TMax);
  constexpr t_t kUnit = 1 << (CoordW + TFrac - DistW);
  for (const t_t t : {TMax - 1, 77 * kUnit, 77 * kUnit - 1, kUnit, kUnit - 1, t_t{0}, t_t{-1}, -kUnit}) {
    offer(result(2, t, 4));
    model.offer(result(2, t, 4));
    expect(2, model);
  }
}

TEST_F(NearestUnit, MatchesModelOverAllContexts) {
  std::mt19937 rng(11);
  std::vector<Nearest> model(kContexts, Nearest(0));
  for (int ctx = 0; ctx < kContexts; ++ctx) start(ctx, 0), model[ctx] = Nearest(0);
  for (int i = 0; i < 20000; ++i) {
    const int ctx = rng() % kContexts;
    if (rng() % 50 == 0) {
      const t_t tmax = rng() % 3 ? TMax : static_cast<t_t>(rng() % 64);
      start(ctx, tmax);
      model[ctx] = Nearest(tmax);
    } else {
      const result_t r = result(ctx, static_cast<t_t>(rng() % 64) - 8, rng() % 8);
      offer(r);
      model[ctx].offer(r);
    }
    const int seen = rng() % kContexts;
    if (rng() % 4 == 0) expect(seen, model[seen]);
  }
}

}  // namespace
}  // namespace castray::tb
