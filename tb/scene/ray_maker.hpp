// SPDX-License-Identifier: Apache-2.0
// Seeded random rays for a scene image: from the eye, from anywhere on the grid, from on and inside primitives;
// at corners, edges, insides of primitives and nowhere; along axes; with limits, culling, ignored primitives, any hit.
#pragma once
#include <random>

#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "mem/prim_reader.hpp"
#include "mem/ray_request.hpp"
#include "scene/compile.hpp"

namespace castray::tb {

class RayMaker {
 public:
  RayMaker(const SceneImage& image, unsigned seed)
      : image_(image), slots_(read_slots(image.bytes.data(), image.header)), random_(seed) {}

  const std::vector<prim_slot_t>& slots() const { return slots_; }

  ray_record_t record() {
    const Point from = origin(), to = target();
    Point d{to.x - from.x, to.y - from.y, to.z - from.z};
    if (one_in(6)) d.x = 0;
    if (one_in(6)) d.y = 0;
    if (one_in(6)) d.z = 0;
    point_t org;
    org.x = static_cast<coord_t>(from.x), org.y = static_cast<coord_t>(from.y), org.z = static_cast<coord_t>(from.z);
    dir_t dir;
    dir.x = d.x * 65536, dir.y = d.y * 65536, dir.z = d.z * 65536;
    if (!one_in(8)) dir.x += in(-32768, 32767), dir.y += in(-32768, 32767), dir.z += in(-32768, 32767);
    ray_record_t record = ray_record(org, dir);
    record.flags |= std::uint64_t{one_in(4)} << RayCull;
    record.flags |= std::uint64_t{one_in(5)} << RayAnyHit;
    if (one_in(5)) record.tmin = one_in(2) ? in(-1 << 20, 1 << 20) : in(0, TMax);
    if (one_in(5)) record.tmax = one_in(2) ? in(0, 1 << 24) : in(0, TMax);
    if (one_in(4)) record.ignore = any().number;
    return record;
  }

  // A ray as a lane takes it: limits below zero and empty ranges too.
  ray_t make() {
    const ray_record_t record = this->record();
    ray_req_t req = ray_request(record, count_++);
    req.tmin = record.tmin;
    req.ok = 1;
    return slab_setup(ray_setup(req));
  }

  // The same ray with limits around a hit of it, or without the primitive that it hits.
  template <class Ray> Ray around(Ray ray, std::int64_t t, std::uint64_t number) {
    switch (in(0, 2)) {
      case 0: ray.tmax = std::min<t_t>(t + in(-1, 1), TMax); break;
      case 1: ray.tmin = t + in(-1, 1); break;
      default: ray.ignore = number;
    }
    return ray;
  }

  bool one_in(int n) { return in(1, n) == 1; }

 private:
  struct Point {
    std::int64_t x, y, z;
  };
  static constexpr std::int64_t kEnd = (1 << CoordW) - 1;

  std::int64_t in(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  const prim_slot_t& any() { return slots_[random_() % slots_.size()]; }
  static Point point_of(const point_t& p) {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
  }
  Point inside(Point p) { return {std::clamp<std::int64_t>(p.x, 0, kEnd), std::clamp<std::int64_t>(p.y, 0, kEnd), std::clamp<std::int64_t>(p.z, 0, kEnd)}; }
  Point anywhere() { return {in(0, kEnd), in(0, kEnd), in(0, kEnd)}; }

  // A point of a primitive: a corner, on an edge, inside; of a sphere within twice its radius.
  Point on_primitive() {
    const prim_slot_t& prim = any();
    const Point a = point_of(prim.a), b = point_of(prim.b), c = point_of(prim.c);
    if (prim.kind == KindSphere) {
      const std::int64_t r = one_in(2) ? b.x : 2 * b.x;
      return inside({a.x + in(-r, r), a.y + in(-r, r), a.z + in(-r, r)});
    }
    if (one_in(4)) return a;
    if (one_in(4)) return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    const std::int64_t u = in(0, 1024), v = in(0, 1024 - u), w = 1024 - u - v;
    const auto mix = [&](std::int64_t p, std::int64_t q, std::int64_t r) { return (p * u + q * v + r * w) / 1024; };
    return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
  }

  Point origin() {
    switch (in(0, 3)) {
      case 0: return anywhere();
      case 1: return on_primitive();
      default: return {static_cast<std::int64_t>(image_.frame.eye_x), static_cast<std::int64_t>(image_.frame.eye_y), static_cast<std::int64_t>(image_.frame.eye_z)};
    }
  }
  Point target() { return one_in(6) ? anywhere() : on_primitive(); }

  const SceneImage& image_;
  std::vector<prim_slot_t> slots_;
  std::mt19937_64 random_;
  std::uint64_t count_ = 0;
};

}  // namespace castray::tb
