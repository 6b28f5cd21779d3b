// SPDX-License-Identifier: Apache-2.0
// Closed meshes, star-shaped around their middle, on the grid; and rays from inside through exact
// points of their edges and corners.
#pragma once
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "camera/ray_setup.hpp"
#include "prim_cases.hpp"

namespace castray::tb {

// Corners lie on multiples of this, so every edge has that many equal parts between grid points.
inline constexpr std::int64_t kParts = 16;
using Grid3 = std::array<std::int64_t, 3>;

inline point_t to_point(const Grid3& p) {
  point_t q;
  q.x = static_cast<std::uint64_t>(p[0]), q.y = static_cast<std::uint64_t>(p[1]), q.z = static_cast<std::uint64_t>(p[2]);
  return q;
}

struct Mesh {
  std::string name;
  std::vector<std::array<Grid3, 3>> faces;  // counter-clockwise from outside
  std::int64_t inside = 0;                  // origins: the middle +- this, each axis

  std::vector<prim_slot_t> slots() const {
    std::vector<prim_slot_t> out;
    for (const auto& f : faces) {
      prim_slot_t s;
      s.a = to_point(f[0]), s.b = to_point(f[1]), s.c = to_point(f[2]);
      s.number = out.size();
      out.push_back(s);
    }
    return out;
  }
};

inline constexpr std::int64_t kMiddle = kHalf;
// A length of the grid of 26 bits, on this one: meshes shrink and grow with it.
inline std::int64_t on_grid(double steps) { return static_cast<std::int64_t>(std::ldexp(steps, int{CoordW} - 26)); }
inline Grid3 snap(const double* p) {
  Grid3 g;
  for (int i = 0; i < 3; ++i) g[i] = kMiddle + kParts * std::llround(p[i] / kParts);
  return g;
}

// An icosahedron, each face split into 64, bumps of a fifth of its radius: 1,280 triangles.
inline Mesh bumpy_sphere(double radius = std::ldexp(2.1e7, int{CoordW} - 26)) {
  using V = std::array<double, 3>;
  const double g = (1 + std::sqrt(5.0)) / 2;
  const V corners[12] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
                         {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  const int ico[20][3] = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                          {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
                          {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
  const int n = 8;
  Mesh mesh{"bumpy sphere", {}, on_grid(1 << 20)};
  for (const auto& face : ico) {
    const auto at = [&](int i, int j) {
      // Weights in a fixed order of the corners, so that neighbours agree in every bit.
      double p[3] = {0, 0, 0};
      std::map<int, int> weight{{face[0], n - i - j}, {face[1], i}, {face[2], j}};
      for (const auto& [corner, w] : weight)
        if (w)
          for (int k = 0; k < 3; ++k) p[k] += w * corners[corner][k];
      const double len = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      for (double& x : p) x /= len;
      const double r = radius * (1 + 0.2 * std::sin(5 * p[0] + 1) * std::sin(6 * p[1]) * std::cos(4 * p[2] + 2));
      for (double& x : p) x *= r;
      return snap(p);
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n - i; ++j) {
        mesh.faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j < n - 1) mesh.faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return mesh;
}

// A cube, each face a lattice of 12 x 12 squares, two triangles each: 1,728.
inline Mesh lattice_cube(std::int64_t square = kParts * on_grid(150000)) {
  const int n = 12;
  Mesh mesh{"lattice cube", {}, 6 * square};
  for (int axis = 0; axis < 3; ++axis)
    for (int side = -1; side <= 1; side += 2)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int di, int dj) {
            Grid3 p;
            p[axis] = kMiddle + side * square * n / 2;
            p[(axis + 1) % 3] = kMiddle + square * (i + di - n / 2);
            p[(axis + 2) % 3] = kMiddle + square * (j + dj - n / 2);
            return p;
          };
          const Grid3 a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
          if (side > 0) mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
          else mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, d, c}});
        }
  return mesh;
}

// Each directed edge has its opposite exactly once, and each face is seen from behind from org.
inline bool closed(const Mesh& mesh) {
  std::map<std::pair<Grid3, Grid3>, int> edges;
  for (const auto& f : mesh.faces)
    for (int i = 0; i < 3; ++i) ++edges[{f[i], f[(i + 1) % 3]}];
  for (const auto& [e, count] : edges) {
    const auto back = edges.find({e.second, e.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return true;
}
inline bool star_shaped_from(const Mesh& mesh, const Grid3& org) {
  for (const auto& f : mesh.faces) {
    double v[3][3];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) v[i][k] = static_cast<double>(f[i][k] - org[k]);
    const double det = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) - v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                       v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    if (!(det > 0)) return false;
  }
  return true;
}

// A ray from inside the mesh through a corner, or an exact point of an edge.
struct AimedRay {
  test_ray_t ray;
  dir_t dir;   // that the ray's shear is divided from
  bool corner = false;
};
inline AimedRay aim(const Mesh& mesh, Rng& rng) {
  Grid3 org;
  // Anywhere inside, or in line with the lattice: then many rays run along grid lines.
  const std::int64_t unit = rng.chance(2) ? 1 : std::max<std::int64_t>(mesh.inside / 6, 1);
  for (auto& x : org) x = kMiddle + unit * rng.in(-(mesh.inside - 1) / unit, (mesh.inside - 1) / unit);
  const auto& face = mesh.faces[static_cast<std::size_t>(rng.in(0, static_cast<std::int64_t>(mesh.faces.size()) - 1))];
  const int side = static_cast<int>(rng.in(0, 2));
  const std::int64_t part = rng.chance(3) ? 0 : rng.in(1, kParts - 1);
  dir_t dir;
  std::int64_t* d[3] = {&dir.x, &dir.y, &dir.z};
  for (int k = 0; k < 3; ++k)
    *d[k] = face[side][k] + (face[(side + 1) % 3][k] - face[side][k]) / kParts * part - org[k];
  camera_t camera;
  camera.eye = to_point(org);
  const ray_t r = ray_setup(dir, camera, {});
  AimedRay a;
  a.dir = dir;
  a.corner = part == 0;
  a.ray.org = r.org;
  a.ray.sx = r.sx, a.ray.sy = r.sy, a.ray.norm2 = r.norm2;
  a.ray.axis = r.axis, a.ray.neg = r.neg;
  return a;
}

}  // namespace castray::tb
