// SPDX-License-Identifier: Apache-2.0
// The references' answers to a list of rays: brute force in double, or in float, over the scene.
#pragma once
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "scene/list_ray.hpp"

namespace castray {

struct ReferenceHit {
  int prim = -1;  // -1: nothing is hit; where any hit will do, one that is
  double distance = std::numeric_limits<double>::infinity();  // from the origin, scene units
  double u = 0;   // weight of corner 0; spheres: 0
  double v = 0;   // weight of corner 1
};

// Called from one thread at a time with the share of the rays finished, 0 to 1.
using ListProgress = std::function<void(double)>;

// threads == 0: as many as the machine has.
std::vector<ReferenceHit> trace_list_float64(const Scene& scene, std::span<const ListRay> rays, int threads = 0, const ListProgress& progress = {});
std::vector<ReferenceHit> trace_list_float32(const Scene& scene, std::span<const ListRay> rays, int threads = 0, const ListProgress& progress = {});

}  // namespace castray
