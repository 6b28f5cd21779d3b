// SPDX-License-Identifier: Apache-2.0
// Work for a lane, rays and primitives that crowd around them, and what its model makes of it.
#pragma once
#include <algorithm>
#include <random>
#include <vector>

#include "isect/hit_unit.hpp"
#include "isect/ray_prim.hpp"
#include "traverse/nearest.hpp"

namespace castray::tb {

inline constexpr std::int64_t kMiddle = 1 << (CoordW - 1), kOne = 1 << ShearFrac;

struct Work {
  std::vector<ray_t> rays;
  std::vector<prim_slot_t> prims;
};

// Rays from the middle of a small box of primitives that crowd around them: many hits and ties.
inline Work random_work(unsigned seed, int rays, int prims) {
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

inline test_ray_t test_ray_of(const ray_t& ray) {
  test_ray_t t;
  t.org = ray.org, t.sx = ray.sx, t.sy = ray.sy, t.norm2 = ray.norm2, t.axis = ray.axis, t.neg = ray.neg, t.cull = ray.cull;
  return t;
}

inline hit_t model_hit(const ray_t& ray, const std::vector<prim_slot_t>& prims, int& tests) {
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

}  // namespace castray::tb
