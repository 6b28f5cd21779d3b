// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/prim_tests.sv: the tests of one ray, and its nearest hit.
#pragma once
#include "isect/hit_unit.hpp"
#include "isect/ray_prim.hpp"
#include "traverse/nearest.hpp"
#include "traverse/ray_store.hpp"

namespace castray {

class PrimTests {
 public:
  explicit PrimTests(const ray_t& ray) : test_ray_(test_ray_of(ray)), hit_ray_(hit_ray_of(ray)), nearest_(ray.tmax) {}

  // accepted(cand, result): the exact test accepts the primitive; `result` is null if it lies before tmin.
  template <class Accepted> void test(const prim_slot_t& slot, Accepted&& accepted) {
    cand_t cand;
    result_t result;
    ++tests_;
    if (!ray_prim(test_ray_, slot, 0, cand)) return;
    const bool beyond = hit_unit(cand, hit_ray_, result);
    if (beyond) nearest_.offer(result);
    accepted(cand, beyond ? &result : nullptr);
  }

  const Nearest& nearest() const { return nearest_; }
  tests_t tests() const { return tests_; }

 private:
  test_ray_t test_ray_;
  hit_ray_t hit_ray_;
  Nearest nearest_;
  tests_t tests_ = 0;
};

}  // namespace castray
