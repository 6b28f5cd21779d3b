// SPDX-License-Identifier: Apache-2.0
#include "scene/teapot.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace castray {
namespace {

// Rim, body, base and lid are surfaces of revolution: four quadrants of rings. A ring of radius r
// has the control points (r, 0), (r, m), (m, r), (0, r), its height is z.
struct Ring {
  double r, m, z;
};
using Profile = std::array<Ring, 4>;

constexpr Profile kProfiles[] = {
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},  // rim
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2.0, 1.12, 1.35}, {2.0, 1.12, 0.9}}},               // body, above
    {{{2.0, 1.12, 0.9}, {2.0, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},               // and below
    {{{0.0, 0.0, 3.15}, {0.8, 0.45, 3.15}, {0.0, 0.0, 2.85}, {0.2, 0.112, 2.7}}},                 // lid's knob
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},             // lid
    {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0.0}, {0.0, 0.0, 0.0}}},              // base
};

// Handle and spout are mirrored at y = 0. A row of a half is (x0, 0, z0), (x0, y, z0), (x1, y, z1),
// (x1, 0, z1).
struct Row {
  double x0, z0, x1, z1, y;
};
using Half = std::array<Row, 4>;

constexpr Half kHalves[] = {
    {{{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3}, {-2.7, 2.025, -3.0, 2.25, 0.3}, {-2.7, 1.8, -3.0, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3.0, 1.8, 0.3}, {-2.7, 1.575, -3.0, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3}, {-2.0, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66}, {2.6, 1.425, 3.1, 0.825, 0.66}, {2.3, 2.1, 2.4, 2.025, 0.25}, {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25}, {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15}, {2.8, 2.4, 3.2, 2.4, 0.15}}},
};

Vec3 y_up(double x, double y, double z) { return {x, z, -y}; }

// To nine decimals: points meet exactly where patches do, and a file of them is short.
double rounded(double x) { return std::round(x * 1e9) / 1e9 + 0.0; }

// Weights of a cubic's control points at k of n, and of its slope.
struct Weights {
  std::array<double, 4> value, slope;
  Weights(int k, int n) {
    const double a = n - k, b = k, cube = double(n) * n * n, square = 3.0 / (double(n) * n);
    value = {a * a * a / cube, 3 * a * a * b / cube, 3 * a * b * b / cube, b * b * b / cube};
    slope = {-a * a * square, (a * a - 2 * a * b) * square, (2 * a * b - b * b) * square, b * b * square};
  }
};
Vec3 sum(const std::array<double, 4>& w, const std::array<Vec3, 4>& p) { return p[0] * w[0] + p[1] * w[1] + p[2] * w[2] + p[3] * w[3]; }

struct Surface {
  Vec3 point, normal;
};

Surface evaluate(const BezierPatch& patch, int column, int row, int n) {
  const Weights u(column, n), v(row, n);
  std::array<Vec3, 4> across, across_slope;
  for (int i = 0; i < 4; ++i) {
    across[i] = sum(u.value, patch[i]);
    across_slope[i] = sum(u.slope, patch[i]);
  }
  Vec3 along_u = sum(v.value, across_slope);
  const Vec3 along_v = sum(v.slope, across);
  // Where the row has shrunk to a point the limit of the tangent's direction is its change along v.
  if (along_u.length2() < 1e-20) along_u = sum(v.slope, across_slope) * (row == n ? -1 : 1);
  return {sum(v.value, across), along_u.cross(along_v).normalized()};
}

}  // namespace

std::array<BezierPatch, 32> teapot_patches() {
  std::array<BezierPatch, 32> patches;
  auto patch = patches.begin();
  for (const Profile& profile : kProfiles) {
    for (int quadrant = 0; quadrant < 4; ++quadrant, ++patch) {
      for (int row = 0; row < 4; ++row) {
        const auto [r, m, z] = profile[row];
        const double xs[] = {r, r, m, 0}, ys[] = {0, m, r, r};
        for (int i = 0; i < 4; ++i) {
          double x = xs[i], y = ys[i];
          for (int turn = 0; turn < quadrant; ++turn) std::tie(x, y) = std::pair(-y, x);
          (*patch)[row][3 - i] = y_up(x, y, z);
        }
      }
    }
  }
  for (const Half& half : kHalves) {
    for (const int side : {-1, 1}) {
      for (int row = 0; row < 4; ++row) {
        const auto [x0, z0, x1, z1, y] = half[row];
        const double xs[] = {x0, x0, x1, x1}, zs[] = {z0, z0, z1, z1}, ys[] = {0, y, y, 0};
        for (int i = 0; i < 4; ++i) (*patch)[row][side < 0 ? i : 3 - i] = y_up(xs[i], side * ys[i], zs[i]);
      }
      ++patch;
    }
  }
  return patches;
}

Mesh teapot_mesh(int n) {
  Mesh mesh;
  std::map<std::tuple<double, double, double>, std::uint32_t> numbers;
  for (const BezierPatch& patch : teapot_patches()) {
    std::vector<std::uint32_t> points;
    std::vector<Vec3> normals;
    for (int row = 0; row <= n; ++row) {
      for (int column = 0; column <= n; ++column) {
        const Surface surface = evaluate(patch, column, row, n);
        const Vec3 point(rounded(surface.point.x), rounded(surface.point.y), rounded(surface.point.z));
        const auto [found, is_new] = numbers.try_emplace({point.x, point.y, point.z}, static_cast<std::uint32_t>(mesh.points.size()));
        if (is_new) mesh.points.push_back(point);
        points.push_back(found->second);
        normals.push_back(surface.normal);
      }
    }
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const std::size_t size = mesh.corners.size();
        const int ring[][2] = {{column + 1, row}, {column + 1, row + 1}, {column, row + 1}, {column, row}};
        for (const auto& [x, y] : ring) {
          const std::size_t at = std::size_t(y) * (n + 1) + x;
          const std::size_t count = mesh.corners.size() - size;
          if (count > 0 && (points[at] == mesh.corners.back() || (count == 3 && points[at] == mesh.corners[size]))) continue;
          mesh.corners.push_back(points[at]);
          mesh.normals.push_back(normals[at]);
          mesh.tex.push_back({double(x) / n, double(y) / n});
        }
        mesh.face_sizes.push_back(static_cast<std::uint32_t>(mesh.corners.size() - size));
      }
    }
  }
  return mesh;
}

}  // namespace castray
