// SPDX-License-Identifier: Apache-2.0
#include "scene/ray_record.hpp"

#include <algorithm>
#include <cmath>

#include "scene/grid.hpp"

namespace castray {
namespace {

double largest_component(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// How much longer the ray is than its extent along its dominant axis: 1 to sqrt(3).
double stretch(const ListRay& ray) { return (ray.direction / largest_component(ray.direction)).length(); }

std::int64_t nearest_t(const SceneImage& image, const ListRay& ray, double distance) {
  const double t = std::ldexp(distance / stretch(ray), static_cast<int>(TFrac - image.header.grid_power));
  return std::llround(std::clamp(t, 0.0, static_cast<double>(TMax)));
}

}  // namespace

ray_record_t ray_record(const SceneImage& image, const ListRay& ray) {
  const Grid grid = image.grid();
  const auto origin = [&](int axis) { return static_cast<std::uint64_t>(grid.at(ray.origin[axis], axis)); };
  const int power = std::ilogb(largest_component(ray.direction));
  const auto direction = [&](int axis) { return std::llround(std::ldexp(ray.direction[axis], static_cast<int>(DirFrac) - power)); };
  ray_record_t record;
  record.org_x = origin(0), record.org_y = origin(1), record.org_z = origin(2);
  record.dir_x = direction(0), record.dir_y = direction(1), record.dir_z = direction(2);
  record.tmin = nearest_t(image, ray, ray.tmin);
  record.tmax = nearest_t(image, ray, ray.tmax);
  record.flags = std::uint64_t{ray.any} << RayAnyHit | std::uint64_t{ray.cull} << RayCull;
  record.ignore = ray.ignore.value_or(NoHit);
  return record;
}

double ray_distance(const SceneImage& image, const ListRay& ray, std::int64_t t) {
  return std::ldexp(static_cast<double>(t) * stretch(ray), static_cast<int>(image.header.grid_power - TFrac));
}

}  // namespace castray
