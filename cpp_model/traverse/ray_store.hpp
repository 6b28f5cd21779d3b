// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/ray_store.sv: what each unit of a lane reads of a ray.
#pragma once
#include "fixed.hpp"

namespace castray {

inline test_ray_t test_ray_of(const ray_t& ray) {
  test_ray_t test;
  test.org = ray.org;
  test.sx = ray.sx;
  test.sy = ray.sy;
  test.norm2 = ray.norm2;
  test.axis = ray.axis;
  test.neg = ray.neg;
  test.cull = ray.cull;
  return test;
}

inline hit_ray_t hit_ray_of(const ray_t& ray) {
  hit_ray_t hit_ray;
  hit_ray.norm2 = ray.norm2;
  hit_ray.neg = ray.neg;
  hit_ray.cull = ray.cull;
  hit_ray.tmin = ray.tmin;
  return hit_ray;
}

inline slab_ray_t slab_ray_of(const ray_t& ray) {
  slab_ray_t slab_ray;
  slab_ray.org = ray.org;
  slab_ray.axis = ray.axis;
  slab_ray.neg = ray.neg;
  slab_ray.rx = ray.rx;
  slab_ray.ry = ray.ry;
  slab_ray.tmin = ray.tmin;
  return slab_ray;
}

}  // namespace castray
