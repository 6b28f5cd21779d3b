// SPDX-License-Identifier: Apache-2.0
// Rays of a list between scene units and the records that the core reads.
#pragma once
#include "scene/compile.hpp"
#include "scene/list_ray.hpp"

namespace castray {

// The record of a ray whose origin lies on the image's grid: the origin to the nearest step, the direction
// scaled by a power of two so that its largest component is 1 to 2, tmin and tmax to the nearest t.
ray_record_t ray_record(const SceneImage& image, const ListRay& ray);

// Distance in scene units of a hit record's t on a ray.
double ray_distance(const SceneImage& image, const ListRay& ray, std::int64_t t);

}  // namespace castray
