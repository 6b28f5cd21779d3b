// SPDX-License-Identifier: Apache-2.0
// Runs long.
// A whole lane against its model: batches of rays past random primitives, all hits equal.
// Verilator: -GContexts=8
#include "Vlane.h"
#include "dut.hpp"
#include "lane_work.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 8;

class Lane : public testing::Test {
 protected:
  Lane() {
    dut_->hierarchy_i = dut_->fill_i = dut_->ray_valid_i = dut_->test_valid_i = dut_->test_step_i = dut_->emit_i = dut_->hit_ready_i = 0;
    dut_->node_fill_valid_i = dut_->leaf_fill_valid_i = dut_->tile_write_i = 0;  // no line comes
    dut_.reset();
  }

  // Offers a ray until it is taken.
  void fill(const ray_t& ray) {
    dut_->fill_i = dut_->ray_valid_i = 1;
    set_port(dut_->ray_i, ray);
    int wait = 0;
    for (dut_.settle(); !dut_->ray_ready_o && wait < 4000; dut_.settle(), ++wait) dut_.tick();
    dut_.tick();
    dut_->fill_i = dut_->ray_valid_i = 0;
    ASSERT_LT(wait, 4000) << "the lane takes no ray";
  }
  // Passes a primitive by the first contexts, whether they hold rays or not. How many were tested.
  std::uint64_t pass(const prim_slot_t& prim, int contexts, Gate& gate) {
    std::uint64_t tests = 0;
    dut_->test_valid_i = 1;
    set_port(dut_->test_prim_i, prim);
    const long limit = dut_.cycles() + 4000;
    for (int ctx = 0; ctx < contexts && dut_.cycles() < limit;) {
      dut_->test_ctx_i = ctx;
      dut_.settle();
      const bool step = dut_->test_ready_o && gate.open();
      dut_->test_step_i = step;
      dut_.settle();
      tests += static_cast<int>(get_port<lane_events_t>(dut_->events_o).test);
      ctx += step;
      dut_.tick();
    }
    dut_->test_valid_i = dut_->test_step_i = 0;
    EXPECT_LT(dut_.cycles(), limit) << "the lane takes no test";
    return tests;
  }
  void wait_until_quiet() {
    int wait = 0;
    for (dut_.settle(); !dut_->quiet_o && wait < 4000; dut_.settle(), ++wait) dut_.tick();
    ASSERT_LT(wait, 4000) << "the lane does not become quiet";
  }
  // Takes the hits of all rays, which are the model's. How many tests the model made.
  std::uint64_t expect_hits(const Work& work, Gate& gate) {
    std::uint64_t tests = 0;
    dut_->emit_i = 1;
    for (std::size_t i = 0; i < work.rays.size() && !HasFailure();) {
      dut_->hit_ready_i = gate.open();
      dut_.settle();
      EXPECT_TRUE(dut_->hit_valid_o);
      if (dut_->hit_ready_i) {
        const hit_t expected = model_hit(work.rays[i], work.prims, tests);
        EXPECT_EQ(to_text(get_port<hit_t>(dut_->hit_o)), to_text(expected)) << "ray " << i;
        ++i;
      }
      dut_.tick();
    }
    dut_->emit_i = dut_->hit_ready_i = 0;
    dut_.settle();
    EXPECT_TRUE(dut_->empty_o);
    return tests;
  }
  // Fills the lane, passes every primitive by the first contexts, waits until it is quiet, takes the hits.
  void run_batch(const Work& work, int contexts, double stall = 0, unsigned seed = 1) {
    Gate gate(stall, 2, seed);
    for (const ray_t& ray : work.rays) ASSERT_NO_FATAL_FAILURE(fill(ray));
    dut_.settle();
    ASSERT_EQ(dut_->used_o, work.rays.size());
    ASSERT_EQ(dut_->full_o, work.rays.size() == kContexts);
    std::uint64_t tests = 0;
    for (const prim_slot_t& prim : work.prims) tests += pass(prim, contexts, gate);
    ASSERT_NO_FATAL_FAILURE(wait_until_quiet());
    EXPECT_EQ(tests, expect_hits(work, gate));
  }
  Dut<Vlane> dut_;
};

TEST_F(Lane, MatchesModelOnRandomBatches) {
  for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    const int rays = 1 + static_cast<int>(seed % kContexts);
    run_batch(random_work(seed, rays, 1 + static_cast<int>(seed * 7 % 90)), rays, seed % 3 * 0.3, seed);
  }
}

// Another lane holds more rays than this one: what is left in the contexts beyond is not tested.
TEST_F(Lane, TestsNoContextThatHoldsNoRay) {
  for (int rays = kContexts; rays > 0 && !HasFailure(); --rays) run_batch(random_work(100 + rays, rays, 40), kContexts);
}

// Every test is accepted: the queue fills, tests wait, and nothing is lost.
TEST_F(Lane, SurvivesWhenEveryTestIsAccepted) {
  Work work = random_work(5, kContexts, 200);
  for (ray_t& ray : work.rays) ray.valid = 1, ray.cull = 0, ray.ignore = NoPrim, ray.tmin = 0, ray.tmax = TMax;
  for (std::size_t i = 0; i < work.prims.size(); ++i) {
    prim_slot_t& slot = work.prims[i];
    slot.kind = i % 5 == 0 ? KindSphere : KindTriangle;
    slot.number = i;
    if (slot.kind == KindSphere) {
      slot.a.x = slot.a.y = slot.a.z = kMiddle;
      slot.b.x = 4000 + i;
    }
  }
  run_batch(work, kContexts);
}

// A ray comes however many cycles behind a test: the cycle in which that one's hit is written is not lost.
TEST_F(Lane, ARayWaitsWhileAHitIsWritten) {
  ray_t ray = random_work(6, 1, 1).rays[0];
  ray.valid = 1, ray.cull = 0, ray.tmin = 0, ray.tmax = TMax, ray.ignore = NoPrim;
  prim_slot_t around;
  around.kind = KindSphere;
  around.a = ray.org;
  around.b.x = 5000;
  Gate gate(0, 1, 1);
  for (int delay = 0; delay < 80 && !HasFailure(); ++delay) {
    fill(ray);
    EXPECT_EQ(pass(around, 1, gate), 1);
    for (int i = 0; i < delay; ++i) dut_.tick();
    fill(ray);
    wait_until_quiet();
    dut_->emit_i = dut_->hit_ready_i = 1;
    for (const bool found : {true, false}) {
      dut_.settle();
      EXPECT_EQ(get_port<hit_t>(dut_->hit_o).found, found) << delay;
      dut_.tick();
    }
    dut_->emit_i = dut_->hit_ready_i = 0;
  }
}

}  // namespace
}  // namespace castray::tb
