// SPDX-License-Identifier: Apache-2.0
// Tests of many contexts at once: when the last one of a ray is over, its nearest hit is the model's.
// Verilator: -GContexts=8
#include "Vprim_tests.h"
#include "dut.hpp"
#include "lane_work.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 8;

class PrimTests : public testing::Test {
 protected:
  struct Context {
    bool used = false;
    ray_t ray;
    int left = 0;         // tests still to be sent
    int under_way = 0;
    bool over = false;    // all are over: u and v come a cycle later
    std::vector<prim_slot_t> sent;
  };

  PrimTests() { dut->start_i = dut->test_valid_i = 0, dut->open_i = 1; }

  // Runs rays of `tests` tests each; `busy`: the share of cycles in which a test is offered.
  void run(const Work& work, int tests, double busy) {
    std::size_t next = 0, ended = 0;
    for (long cycle = 0; ended < work.rays.size(); ++cycle) {
      ASSERT_LT(cycle, 100000) << "a test is never over";
      send(work, tests, busy, next);
      dut.settle();
      set_port(dut->hit_ray_i, hit_ray_of(contexts[dut->hit_ctx_o].ray));
      dut.settle();
      for (int way = 0; way < 2; ++way) {
        if (!(dut->over_o >> way & 1)) continue;
        Context& c = contexts[dut->over_ctx_o[way]];
        ASSERT_GT(c.under_way--, 0);
        accepted += way;
      }
      dut.tick();
      for (int ctx = 0; ctx < kContexts; ++ctx) {
        Context& c = contexts[ctx];
        if (!c.used || c.left > 0 || c.under_way > 0) continue;
        if (!std::exchange(c.over, true)) continue;
        c.used = false;
        ++ended;
        ASSERT_NO_FATAL_FAILURE(expect(ctx, c));
      }
    }
  }

  Dut<Vprim_tests> dut;
  std::mt19937 rng{9};
  int accepted = 0, refused = 0;

 private:
  void send(const Work& work, int tests, double busy, std::size_t& next) {
    dut->start_i = dut->test_valid_i = 0;
    dut.settle();
    const int ctx = static_cast<int>(rng() % kContexts);
    Context& c = contexts[ctx];
    if (c.used && c.left > 0 && dut->test_ready_o && rng() % 1000 < busy * 1000) {
      const prim_slot_t& prim = work.prims[rng() % work.prims.size()];
      dut->test_valid_i = 1, dut->test_ctx_i = ctx;
      set_port(dut->test_ray_i, test_ray_of(c.ray));
      set_port(dut->test_prim_i, prim);
      c.sent.push_back(prim);
      --c.left, ++c.under_way;
    }
    refused += !dut->test_ready_o;
    dut.settle();
    if (!c.used && next < work.rays.size() && dut->start_ready_o) {
      c = Context{.used = true, .ray = work.rays[next++], .left = tests};
      dut->start_i = 1, dut->start_ctx_i = ctx;
      set_signed(dut->tmax_i, c.ray.tmax, t_t_bits);
    }
  }

  void expect(int ctx, const Context& c) {
    std::uint64_t tests = 0;
    ray_t ray = c.ray;
    ray.valid = 1, ray.ignore = NoPrim;
    const hit_t hit = model_hit(ray, c.sent, tests);
    dut->start_i = dut->test_valid_i = 0;
    dut->out_ctx_i = dut->step_ctx_i[0] = dut->step_ctx_i[1] = ctx;
    dut.settle();
    const result_t best = get_port<result_t>(dut->out_o);
    ASSERT_EQ(dut->out_found_o, hit.found);
    ASSERT_EQ(dut->step_found_o, hit.found ? 3 : 0);
    EXPECT_EQ(best.t, hit.t);
    EXPECT_EQ(best.number, hit.number);
    EXPECT_EQ(best.u, hit.u);
    EXPECT_EQ(best.v, hit.v);
    EXPECT_EQ(dut->out_tests_o, tests);
  }

  Context contexts[64];
};

TEST_F(PrimTests, MatchesModelOnRandomTests) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    run(random_work(seed, 200, 30), static_cast<int>(seed), seed % 3 ? 1 : 0.3);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(accepted, 1000);
}

// Spheres around the ray's origin: each test is accepted, the divider is behind, tests are refused.
TEST_F(PrimTests, HoldsWhatItAccepts) {
  Work work = random_work(3, 100, 20);
  for (ray_t& ray : work.rays) ray.cull = 0, ray.tmin = 0, ray.tmax = TMax;
  for (prim_slot_t& prim : work.prims) {
    prim.kind = KindSphere;
    prim.a = work.rays[0].org;
    prim.b.x = 5000 + prim.number;
  }
  run(work, 40, 1);
  EXPECT_EQ(accepted, 4000);
  EXPECT_GT(refused, 1000);
}

// The hit unit takes nothing until tests are refused and all that were not have come to the queue.
TEST_F(PrimTests, HoldsWhatIsUnderWayWhileTheHitUnitIsClosed) {
  Work work = random_work(4, 1, 1);
  ray_t& ray = work.rays[0];
  ray.cull = 0, ray.tmin = 0, ray.tmax = TMax;
  prim_slot_t around;
  around.kind = KindSphere;
  around.a = ray.org;
  around.b.x = 5000;
  set_port(dut->test_ray_i, test_ray_of(ray));
  set_port(dut->hit_ray_i, hit_ray_of(ray));
  set_port(dut->test_prim_i, around);
  dut->test_ctx_i = 0, dut->open_i = 0;
  int sent = 0, over = 0;
  for (dut.settle(); dut->test_ready_o && sent < 100; dut.settle(), ++sent) {
    dut->test_valid_i = 1;
    dut.tick();
    dut->test_valid_i = 0;
  }
  EXPECT_EQ(sent, 32);
  for (int cycle = 0; cycle < 200; ++cycle) {
    dut->open_i = cycle >= 20;
    dut.settle();
    over += dut->over_o >> 1 & 1;
    dut.tick();
  }
  EXPECT_EQ(over, sent);
  dut.settle();
  EXPECT_TRUE(dut->idle_o);
}

}  // namespace
}  // namespace castray::tb
