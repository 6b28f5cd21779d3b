// SPDX-License-Identifier: Apache-2.0
#include "reference/ray_list.hpp"

#include <algorithm>

#include "parallel.hpp"
#include "reference/triangle_list.hpp"
#include "scene/vectors.hpp"

namespace castray {
namespace {

template <class T> class Tracer {
  using V = Imath::Vec3<T>;

 public:
  explicit Tracer(const Scene& scene) : scene_(scene), triangles_(scene, Vec3(0)) {}

  ReferenceHit hit(const ListRay& ray) const {
    const Line line{V(ray.origin), V(unit_or_zero(ray.direction)), std::max(T(0), T(ray.tmin)), ray.cull, ray.ignore ? std::size_t{*ray.ignore} : kNone};
    T nearest = T(ray.tmax);
    std::size_t prim = kNone;
    triangles_.nearest([&](std::size_t i) {
      const auto at = triangles_.cross(i, line.from, line.along);
      const bool hit = at.inside() & (at.t > line.tmin) & (!line.cull | (at.det > 0)) & (i != line.ignore);
      return hit ? at.t : kFar;
    }, nearest, prim, ray.any);
    for (std::size_t i = 0; i < scene_.spheres.size() && !(ray.any && prim != kNone); ++i) {
      const T t = line.ignore == scene_.triangles.size() + i ? nearest : sphere(line, scene_.spheres[i]);
      if (t < nearest) nearest = t, prim = scene_.triangles.size() + i;
    }
    if (prim == kNone) return {};
    ReferenceHit hit{.prim = static_cast<int>(prim), .distance = double(nearest)};
    if (prim < scene_.triangles.size()) {
      const auto at = triangles_.cross(prim, line.from, line.along);
      hit.u = double(1 - at.u - at.v);
      hit.v = double(at.u);
    }
    return hit;
  }

 private:
  static constexpr T kFar = std::numeric_limits<T>::infinity();
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  struct Line {
    V from, along;  // along: of unit length
    T tmin;
    bool cull;
    std::size_t ignore;
  };

  T sphere(const Line& line, const Sphere& sphere) const {
    const auto at = reference::roots<T>(line.from - V(sphere.centre), T(sphere.radius), line.along);
    if (at.near > line.tmin) return at.near;
    return at.far > line.tmin && !line.cull ? at.far : kFar;
  }

  const Scene& scene_;
  reference::TriangleList<T> triangles_;
};

template <class T>
std::vector<ReferenceHit> trace(const Scene& scene, std::span<const ListRay> rays, int threads, const ListProgress& progress) {
  constexpr std::size_t part = 64;
  const Tracer<T> tracer(scene);
  std::vector<ReferenceHit> hits(rays.size());
  std::size_t done = 0;
  parallel((rays.size() + part - 1) / part, threads,
           [&](std::size_t n) {
             const std::size_t first = n * part, end = std::min(first + part, rays.size());
             for (std::size_t i = first; i < end; ++i) hits[i] = tracer.hit(rays[i]);
             return end - first;
           },
           [&](std::size_t, std::size_t count, std::size_t) {
             done += count;
             if (progress) progress(double(done) / double(rays.size()));
             return true;
           });
  return hits;
}

}  // namespace

std::vector<ReferenceHit> trace_list_float64(const Scene& scene, std::span<const ListRay> rays, int threads, const ListProgress& progress) {
  return trace<double>(scene, rays, threads, progress);
}
std::vector<ReferenceHit> trace_list_float32(const Scene& scene, std::span<const ListRay> rays, int threads, const ListProgress& progress) {
  return trace<float>(scene, rays, threads, progress);
}

}  // namespace castray
