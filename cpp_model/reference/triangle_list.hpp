// SPDX-License-Identifier: Apache-2.0
// The triangles of a scene by component, and the nearest of them, for either type of number.
#pragma once
#include <array>
#include <vector>

#include "reference/crossing.hpp"
#include "scene/scene.hpp"

namespace castray::reference {

template <class T> class TriangleList {
  using V = Imath::Vec3<T>;
  static constexpr std::size_t kBlock = 64;

 public:
  // Corners are taken from `origin`.
  TriangleList(const Scene& scene, const Vec3& origin) {
    const std::size_t count = (scene.triangles.size() + kBlock - 1) / kBlock * kBlock;
    for (auto& axis : data_) axis.resize(count);  // padding: triangles of no area, never hit
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
      const auto& [a, b, c] = scene.triangles[i].corner;
      for (int k = 0; k < 3; ++k) {
        data_[k][i] = T(a[k] - origin[k]);
        data_[3 + k][i] = T(b[k] - a[k]);
        data_[6 + k][i] = T(c[k] - a[k]);
      }
    }
  }

  V corner(std::size_t i) const { return at(0, i); }
  V edge_b(std::size_t i) const { return at(3, i); }  // to the second corner
  V edge_c(std::size_t i) const { return at(6, i); }  // to the third

  // Where the line from `from` along d crosses triangle i.
  Crossing<T> cross(std::size_t i, const V& from, const V& d) const { return crossing<T>(corner(i) - from, edge_b(i), edge_c(i), d); }

  // t_of(i) is where triangle i is hit, not below `nearest` if it is not. A block of tests at a time,
  // written so that the compiler makes vectors of them. first_only: any will do.
  template <class TOf, class Prim> void nearest(TOf&& t_of, T& nearest, Prim& prim, bool first_only = false) const {
    for (std::size_t first = 0; first < data_[0].size(); first += kBlock) {
      std::array<T, kBlock> t;
      int any = 0;
      for (std::size_t i = 0; i < kBlock; ++i) {
        t[i] = t_of(first + i);
        any |= t[i] < nearest;
      }
      if (!any) continue;
      for (std::size_t i = 0; i < kBlock; ++i)
        if (t[i] < nearest) nearest = t[i], prim = static_cast<Prim>(first + i);
      if (first_only) return;
    }
  }

 private:
  V at(int k, std::size_t i) const { return {data_[k][i], data_[k + 1][i], data_[k + 2][i]}; }

  std::array<std::vector<T>, 9> data_;  // corner, two edges
};

}  // namespace castray::reference
