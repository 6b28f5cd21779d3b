// SPDX-License-Identifier: Apache-2.0
// Work for a lane, rays and primitives that crowd around them, and what its model makes of it.
#pragma once
#include <algorithm>
#include <random>
#include <vector>

#include "traverse/lane.hpp"

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

// How many tests the ray makes is added to `tests`.
inline hit_t model_hit(const ray_t& ray, const std::vector<prim_slot_t>& prims, std::uint64_t& tests) {
  return lane(ray, prims, tests, [](const cand_t&, const result_t*) {});
}

}  // namespace castray::tb
