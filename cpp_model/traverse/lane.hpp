// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/lane.sv: the nearest of the primitives that a ray meets.
#pragma once
#include <vector>

#include "traverse/prim_tests.hpp"

namespace castray {

inline hit_t hit_of(const ray_t& ray, const Nearest& nearest) {
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

// Adds the tests that the ray makes to `tests`. accepted(cand, result) is told of each
// primitive that the exact test accepts; `result` is null where it lies before tmin.
template <class Accepted>
hit_t lane(const ray_t& ray, const std::vector<prim_slot_t>& slots, std::uint64_t& tests, Accepted&& accepted) {
  PrimTests prims(ray);
  for (const prim_slot_t& slot : slots)
    if (ray.valid && slot.number != ray.ignore) prims.test(slot, accepted);
  tests += prims.tests();
  return hit_of(ray, prims.nearest());
}

}  // namespace castray
