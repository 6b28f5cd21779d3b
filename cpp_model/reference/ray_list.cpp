// SPDX-License-Identifier: Apache-2.0
#include "reference/ray_list.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "reference/crossing.hpp"
#include "scene/vectors.hpp"

namespace castray {
namespace {

template <class T> class Tracer {
  using V = Imath::Vec3<T>;
  static constexpr std::size_t kBlock = 64;

 public:
  explicit Tracer(const Scene& scene) : scene_(scene) {
    const std::size_t count = (scene.triangles.size() + kBlock - 1) / kBlock * kBlock;
    for (auto& axis : data_) axis.resize(count);  // padding: triangles of no area, never hit
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
      const auto& [a, b, c] = scene.triangles[i].corner;
      for (int k = 0; k < 3; ++k) {
        data_[k][i] = T(a[k]);
        data_[3 + k][i] = T(b[k] - a[k]);
        data_[6 + k][i] = T(c[k] - a[k]);
      }
    }
  }

  ReferenceHit hit(const ListRay& ray) const {
    const Line line{V(ray.origin), V(unit_or_zero(ray.direction)), std::max(T(0), T(ray.tmin)), ray.cull, ray.ignore ? std::size_t{*ray.ignore} : kNone};
    T nearest = T(ray.tmax);
    std::size_t prim = kNone;
    for (std::size_t first = 0; first < data_[0].size() && !(ray.any && prim != kNone); first += kBlock) block(line, first, nearest, prim);
    for (std::size_t i = 0; i < scene_.spheres.size() && !(ray.any && prim != kNone); ++i) {
      const T t = line.ignore == scene_.triangles.size() + i ? nearest : sphere(line, scene_.spheres[i]);
      if (t < nearest) nearest = t, prim = scene_.triangles.size() + i;
    }
    if (prim == kNone) return {};
    ReferenceHit hit{.prim = static_cast<int>(prim), .distance = double(nearest)};
    if (prim < scene_.triangles.size()) {
      const auto at = cross(line, prim);
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

  reference::Crossing<T> cross(const Line& line, std::size_t i) const {
    const auto at = [&](int k) { return V(data_[k][i], data_[k + 1][i], data_[k + 2][i]); };
    return reference::crossing<T>(at(0) - line.from, at(3), at(6), line.along);
  }

  // A block of tests at a time, written so that the compiler makes vectors of them.
  void block(const Line& line, std::size_t first, T& nearest, std::size_t& prim) const {
    std::array<T, kBlock> t;
    int any = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
      const auto at = cross(line, first + i);
      const bool hit = at.inside() & (at.t > line.tmin) & (!line.cull | (at.det > 0)) & (first + i != line.ignore);
      t[i] = hit ? at.t : kFar;
      any |= t[i] < nearest;
    }
    if (!any) return;
    for (std::size_t i = 0; i < kBlock; ++i)
      if (t[i] < nearest) nearest = t[i], prim = first + i;
  }

  T sphere(const Line& line, const Sphere& sphere) const {
    const auto at = reference::roots<T>(line.from - V(sphere.centre), T(sphere.radius), line.along);
    if (at.near > line.tmin) return at.near;
    return at.far > line.tmin && !line.cull ? at.far : kFar;
  }

  const Scene& scene_;
  std::array<std::vector<T>, 9> data_;  // corner 0, two edges; by component
};

template <class T>
std::vector<ReferenceHit> trace(const Scene& scene, std::span<const ListRay> rays, int threads, const ListProgress& progress) {
  constexpr std::size_t part = 64;
  const Tracer<T> tracer(scene);
  std::vector<ReferenceHit> hits(rays.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0;
  const auto work = [&] {
    for (std::size_t first = next.fetch_add(part); first < rays.size(); first = next.fetch_add(part)) {
      const std::size_t end = std::min(first + part, rays.size());
      for (std::size_t i = first; i < end; ++i) hits[i] = tracer.hit(rays[i]);
      const std::lock_guard lock(mutex);
      done += end - first;
      if (progress) progress(double(done) / double(rays.size()));
    }
  };
  std::vector<std::jthread> pool;
  for (int i = 1; i < (threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())); ++i) pool.emplace_back(work);
  work();
  pool.clear();
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
