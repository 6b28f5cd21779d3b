// SPDX-License-Identifier: Apache-2.0
// A whole lane against its model: batches of rays past random primitives, all hits equal.
// Verilator: -GContexts=8
#include "Vlane.h"
#include "dut.hpp"
#include "isect/hit_unit.hpp"
#include "isect/ray_prim.hpp"
#include "traverse/nearest.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 8;
constexpr std::int64_t kMiddle = 1 << (CoordW - 1), kOne = 1 << ShearFrac;

struct Work {
  std::vector<ray_t> rays;
  std::vector<prim_slot_t> prims;
};

// Rays from the middle of a small box of primitives that crowd around them: many hits and ties.
Work random_work(unsigned seed, int rays, int prims) {
  std::mt19937 rng(seed);
  const auto coord = [&] { return static_cast<coord_t>(kMiddle + static_cast<int>(rng() % 4001) - 2000); };
  const auto point = [&] {
    point_t p;
    p.x = coord(), p.y = coord(), p.z = coord();
    return p;
  };
  Work work;
  for (int i = 0; i < rays; ++i) {
    ray_t ray;
    ray.tag.x = rng() % 4096, ray.tag.y = rng() % 4096, ray.tag.slot = rng() % 256;
    ray.org.x = ray.org.y = ray.org.z = kMiddle;
    ray.axis = rng() % 3;
    ray.neg = rng() % 2;
    ray.sx = static_cast<std::int64_t>(rng() % (2 * kOne - 1)) - kOne + 1;
    ray.sy = static_cast<std::int64_t>(rng() % (2 * kOne - 1)) - kOne + 1;
    ray.norm2 = static_cast<norm2_t>(round_shift(kOne * kOne + ray.sx * ray.sx + ray.sy * ray.sy, 2 * ShearFrac - NormFrac));
    ray.valid = rng() % 10 != 0;
    ray.cull = rng() % 4 == 0;
    ray.tmin = rng() % 3 ? 0 : static_cast<t_t>(rng() % 20000);
    ray.tmax = rng() % 3 ? TMax : static_cast<t_t>(rng() % 40000);
    ray.ignore = rng() % 2 ? NoPrim : rng() % prims;
    work.rays.push_back(ray);
  }
  for (int i = 0; i < prims; ++i) {
    prim_slot_t slot;
    if (i > 0 && rng() % 4 == 0) {
      slot = work.prims[rng() % i];  // a duplicate: equal distances, the lower number wins
    } else {
      slot.kind = rng() % 4 == 0;
      slot.a = point(), slot.b = point(), slot.c = point();
      if (slot.kind == KindSphere) slot.b.x = 1 + rng() % 3000;
    }
    slot.number = static_cast<prim_t>(i);
    work.prims.push_back(slot);
  }
  std::shuffle(work.prims.begin(), work.prims.end(), rng);
  return work;
}

test_ray_t test_ray_of(const ray_t& ray) {
  test_ray_t t;
  t.org = ray.org, t.sx = ray.sx, t.sy = ray.sy, t.norm2 = ray.norm2, t.axis = ray.axis, t.neg = ray.neg, t.cull = ray.cull;
  return t;
}

hit_t model_hit(const ray_t& ray, const std::vector<prim_slot_t>& prims, int& tests) {
  Nearest nearest(ray.tmax);
  hit_ray_t hit_ray;
  hit_ray.norm2 = ray.norm2, hit_ray.neg = ray.neg, hit_ray.cull = ray.cull, hit_ray.tmin = ray.tmin;
  for (const prim_slot_t& slot : prims) {
    if (!ray.valid || slot.number == ray.ignore) continue;
    ++tests;
    cand_t cand;
    result_t result;
    if (ray_prim(test_ray_of(ray), slot, 0, cand) && hit_unit(cand, hit_ray, result)) nearest.offer(result);
  }
  hit_t hit;
  hit.tag = ray.tag, hit.found = nearest.found();
  hit.kind = nearest.best().kind, hit.number = nearest.best().number, hit.t = nearest.best().t;
  hit.u = nearest.best().u, hit.v = nearest.best().v;
  hit.sx = ray.sx, hit.sy = ray.sy, hit.axis = ray.axis, hit.neg = ray.neg;
  return hit;
}

// Fills the lane, passes every primitive by every context, waits until it is quiet, takes the hits.
void run_batch(Dut<Vlane>& dut, const Work& work, double stall, unsigned seed) {
  Gate gate(stall, 2, seed);
  dut->fill_i = 1, dut->emit_i = 0, dut->test_valid_i = 0, dut->hit_ready_i = 0;
  for (const ray_t& ray : work.rays) {
    dut->ray_valid_i = 1;
    set_port(dut->ray_i, ray);
    dut.settle();
    ASSERT_TRUE(dut->ray_ready_o);
    dut.tick();
  }
  dut->ray_valid_i = 0, dut->fill_i = 0;
  dut.settle();
  ASSERT_EQ(dut->used_o, work.rays.size());
  ASSERT_EQ(dut->full_o, work.rays.size() == kContexts);

  int tests = 0;
  for (const prim_slot_t& prim : work.prims)
    for (std::size_t ctx = 0; ctx < work.rays.size();) {
      dut->test_valid_i = 1;
      dut->test_ctx_i = ctx;
      set_port(dut->test_prim_i, prim);
      dut.settle();
      const bool step = dut->test_ready_o && gate.open();
      dut->test_step_i = step;
      dut.settle();
      tests += dut->test_o;
      ctx += step;
      dut.tick();
    }
  dut->test_valid_i = 0, dut->test_step_i = 0;
  int wait = 0;
  for (dut.settle(); !dut->quiet_o && wait < 4000; dut.settle(), ++wait) dut.tick();
  ASSERT_LT(wait, 4000) << "the lane does not become quiet";

  dut->emit_i = 1;
  int model_tests = 0;
  for (std::size_t i = 0; i < work.rays.size();) {
    dut->hit_ready_i = gate.open();
    dut.settle();
    ASSERT_TRUE(dut->hit_valid_o);
    if (dut->hit_ready_i) {
      const hit_t expected = model_hit(work.rays[i], work.prims, model_tests);
      ASSERT_EQ(to_text(get_port<hit_t>(dut->hit_o)), to_text(expected)) << "ray " << i;
      ++i;
    }
    dut.tick();
  }
  dut->emit_i = 0;
  dut.settle();
  EXPECT_TRUE(dut->empty_o);
  EXPECT_EQ(tests, model_tests);
}

TEST(Lane, MatchesModelOnRandomBatches) {
  Dut<Vlane> dut;
  for (unsigned seed = 1; seed <= 60; ++seed)
    run_batch(dut, random_work(seed, 1 + seed % kContexts, 1 + static_cast<int>(seed * 7 % 90)), seed % 3 * 0.3, seed);
}

// Every test is accepted: the queue fills, tests wait, and nothing is lost.
TEST(Lane, SurvivesWhenEveryTestIsAccepted) {
  Dut<Vlane> dut;
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
  run_batch(dut, work, 0, 1);
}

}  // namespace
}  // namespace castray::tb
