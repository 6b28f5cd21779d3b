// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/lane.sv: the nearest of the primitives that a ray meets.
#pragma once
#include <vector>

#include "isect/hit_unit.hpp"
#include "isect/ray_prim.hpp"
#include "traverse/nearest.hpp"
#include "traverse/ray_store.hpp"

namespace castray {

// Adds the tests that the ray makes to `tests`. accepted(cand, result) is told of each primitive
// that the exact test accepts; `result` is null where it lies before tmin.
template <class Accepted>
hit_t lane(const ray_t& ray, const std::vector<prim_slot_t>& slots, std::uint64_t& tests, Accepted&& accepted) {
  const test_ray_t test_ray = test_ray_of(ray);
  const hit_ray_t hit_ray = hit_ray_of(ray);
  Nearest nearest(ray.tmax);
  cand_t cand;
  result_t result;
  for (const prim_slot_t& slot : slots) {
    if (!ray.valid || slot.number == ray.ignore) continue;
    ++tests;
    if (!ray_prim(test_ray, slot, 0, cand)) continue;
    const bool beyond = hit_unit(cand, hit_ray, result);
    if (beyond) nearest.offer(result);
    accepted(cand, beyond ? &result : nullptr);
  }

  const result_t& best = nearest.best();
  hit_t hit;
  hit.tag = ray.tag;
  hit.found = nearest.found();
  hit.kind = best.kind;
  hit.number = best.number;
  hit.t = best.t;
  hit.u = best.u;
  hit.v = best.v;
  hit.sx = ray.sx;
  hit.sy = ray.sy;
  hit.axis = ray.axis;
  hit.neg = ray.neg;
  return hit;
}

}  // namespace castray
