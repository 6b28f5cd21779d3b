// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/lane.sv: the nearest of the primitives that a ray meets, found in one of two ways.
#pragma once
#include <vector>

#include "traverse/leaf_tests.hpp"
#include "traverse/node_visits.hpp"
#include "traverse/prim_tests.hpp"
#include "traverse/step.hpp"

namespace castray {

inline hit_t hit_of(const ray_t& ray, const Nearest& nearest) {
  const result_t& best = nearest.best();
  hit_t hit;
  hit.tag = ray.tag;
  hit.found = nearest.found();
  hit.any_hit = ray.any_hit;
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

// One node or leaf that a ray goes to, and the node's children that it visits.
struct Visit {
  ref_t target;
  visits_t children;
};

// Who is told of the visits and tests of a ray, in their order: nobody.
struct NoWatch {
  void visit(const Visit&) {}
  void test(const prim_slot_t&) {}
};

// By brute force. Adds the tests that the ray makes to `tests`. accepted(cand, result) is told of each
// primitive that the exact test accepts; `result` is null where it lies before tmin.
template <class Accepted, class Watch = NoWatch>
hit_t lane(const ray_t& ray, const std::vector<prim_slot_t>& slots, std::uint64_t& tests, Accepted&& accepted, Watch&& watch = {}) {
  PrimTests prims(ray);
  for (const prim_slot_t& slot : slots) {
    if (!ray.valid || slot.number == ray.ignore) continue;
    watch.test(slot);
    prims.test(slot, accepted);
  }
  tests += prims.tests();
  return hit_of(ray, prims.nearest());
}

// What the hierarchy reads: the scene image, and the nodes of a tile's frontier.
struct Tree {
  const std::uint8_t* image;
  const image_header_t* header;
  steps_t limit;                     // nodes that a ray may visit
  std::span<const node_t> tile = {};
  int stack_depth = StackFrames;

  start_t root() const {
    start_t start;
    start.first.kind = header->root >> LineW;
    start.first.index = header->root & ((std::uint64_t{1} << LineW) - 1);
    return start;
  }
};

struct TreeHit {
  hit_t hit;       // meaningless with an error
  work_t work;
  error_t error = ErrNone;
};

// Through the hierarchy, from `start` on.
template <class Accepted, class Watch = NoWatch>
TreeHit lane(const ray_t& ray, const Tree& tree, const start_t& start, Accepted&& accepted, Watch&& watch = {}) {
  const slab_ray_t slab_ray = slab_ray_of(ray);
  PrimTests prims(ray);
  Step step(tree.limit, tree.stack_depth);
  visits_t visits = visits_of(ray.valid ? start : start_t{});
  error_t error = ErrNone;
  while (error == ErrNone) {
    const t_t t = prims.nearest().best().t;
    const Step::Next next = step.next(visits, dist_of(t), ray.any_hit && prims.nearest().found());
    error = step.error();
    if (next != Step::Next::Visit) break;
    const ref_t target = step.target();
    visits = {};
    const auto test = [&](const prim_slot_t& slot) {
      watch.test(slot);
      prims.test(slot, accepted);
    };
    if (target.kind == static_cast<std::uint64_t>(RefLeaf))
      error = leaf_tests(tree.image, *tree.header, target.index, ray.ignore, test);
    else
      error = node_visits(tree.image, *tree.header, tree.tile, target, slab_ray, t, visits);
    watch.visit({target, visits});
  }
  return {hit_of(ray, prims.nearest()), {.nodes = step.nodes(), .tests = prims.tests()}, error};
}

}  // namespace castray
