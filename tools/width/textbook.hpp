// SPDX-License-Identifier: Apache-2.0
// What castray does not do, for comparison: the test of Moller and Trumbore (1997) in fixed-point numbers of one format, each
// product and quotient truncated to it, as HLS types do by default. Frac fraction bits; integer bits as many as it takes.
#pragma once
#include "model.hpp"

namespace castray::width {

template <int Frac> struct Textbook {
  using T = std::int64_t;
  struct V {
    T x, y, z;
  };
  static constexpr T kOne = T{1} << Frac;

  static T of(double x) { return static_cast<T>(std::floor(std::ldexp(x, Frac))); }
  static V of(const Vec3& v) { return {of(v.x), of(v.y), of(v.z)}; }
  static T mul(T a, T b) { return static_cast<T>((int128{a} * b) >> Frac); }
  static T div(T a, T b) {   // towards zero
    return static_cast<T>((int128{a} << Frac) / b);
  }
  static V sub(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  static T dot(const V& a, const V& b) { return mul(a.x, b.x) + mul(a.y, b.y) + mul(a.z, b.z); }
  static V cross(const V& a, const V& b) { return {mul(a.y, b.z) - mul(a.z, b.y), mul(a.z, b.x) - mul(a.x, b.z), mul(a.x, b.y) - mul(a.y, b.x)}; }

  // The distance along d in front of org, or 0.
  static T hit(const V& org, const V& d, const V& a, const V& b, const V& c) {
    const V e1 = sub(b, a), e2 = sub(c, a), p = cross(d, e2);
    const T det = dot(e1, p);
    if (det == 0) return 0;
    const V s = sub(org, a);
    const T u = div(dot(s, p), det);
    if (u < 0 || u > kOne) return 0;
    const V q = cross(s, e1);
    const T v = div(dot(d, q), det);
    if (v < 0 || u + v > kOne) return 0;
    return std::max<T>(div(dot(e2, q), det), 0);
  }

  static int wrong(const View& view) {
    const auto lists = tile_lists(view.scene, std::ldexp(64.0, -Frac));
    std::vector<std::array<V, 3>> triangles;
    for (const Triangle& t : view.scene.triangles) triangles.push_back({of(t.corner[0]), of(t.corner[1]), of(t.corner[2])});
    const V eye = of(view.scene.camera.eye());
    return errors(view, [&](std::size_t tile, int x, int y) {
      const V d = of(pixel_direction(view.scene, kWidth, kHeight, x, y).normalized());
      Pixel pixel;
      T nearest = INT64_MAX;
      for (const std::size_t i : lists[tile])
        if (const T t = hit(eye, d, triangles[i][0], triangles[i][1], triangles[i][2]); t > 0 && t < nearest) {
          nearest = t;
          pixel.prim = static_cast<std::int32_t>(i);
        }
      return pixel;
    }).wrong;
  }

  // A mesh on the grid, whose step is one last bit.
  static Cracks mesh_cracks(const tb::Mesh& mesh, long rays) {
    const auto at = [](const tb::Grid3& g) { return V{g[0] - tb::kMiddle, g[1] - tb::kMiddle, g[2] - tb::kMiddle}; };
    return cracks(mesh, rays, [&](const tb::AimedRay& aimed, std::size_t face) {
      const auto centred = [](coord_t x) { return static_cast<T>(x) - tb::kMiddle; };
      const V org{centred(aimed.ray.org.x), centred(aimed.ray.org.y), centred(aimed.ray.org.z)};
      const double length = std::sqrt(std::pow(double(aimed.dir.x), 2) + std::pow(double(aimed.dir.y), 2) + std::pow(double(aimed.dir.z), 2));
      const V d{of(double(aimed.dir.x) / length), of(double(aimed.dir.y) / length), of(double(aimed.dir.z) / length)};
      const auto& f = mesh.faces[face];
      return hit(org, d, at(f[0]), at(f[1]), at(f[2])) > 0;
    });
  }
};

}  // namespace castray::width
