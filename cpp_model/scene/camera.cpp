// SPDX-License-Identifier: Apache-2.0
#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/vectors.hpp"

namespace castray {

namespace {
// The least sine of the angle between up and the direction of view. Below it rounding decides where
// right points, and the three axes are no longer square to each other.
constexpr double kLeastSine = 1e-9;
}  // namespace

bool look_at(const Vec3& eye, const Vec3& target, const Vec3& up, Matrix& to_world) {
  const Vec3 back = unit_or_zero(eye - target);
  const Vec3 across = unit_or_zero(up).cross(back);
  if (!(across.length() > kLeastSine)) return false;
  const Vec3 right = unit_or_zero(across);
  const Vec3 above = back.cross(right);
  for (int i = 0; i < 3; ++i) {
    to_world[0][i] = right[i];
    to_world[1][i] = above[i];
    to_world[2][i] = back[i];
    to_world[3][i] = eye[i];
    to_world[i][3] = 0;
  }
  to_world[3][3] = 1;
  return true;
}

void bounds(const Scene& scene, Vec3& low, Vec3& high) {
  low = Vec3(std::numeric_limits<double>::max());
  high = -low;
  const auto add = [&](const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], a[i]);
      high[i] = std::max(high[i], b[i]);
    }
  };
  for (const Triangle& triangle : scene.triangles)
    for (const Vec3& corner : triangle.corner) add(corner, corner);
  for (const Sphere& sphere : scene.spheres) add(sphere.centre - Vec3(sphere.radius), sphere.centre + Vec3(sphere.radius));
}

bool frame_scene(Scene& scene) {
  Vec3 low, high;
  bounds(scene, low, high);
  const Vec3 centre = (low + high) / 2;
  const double radius = (high - low).length() / 2;
  const double half = scene.camera.field_of_view * std::numbers::pi / 360;
  const double narrow = std::atan(std::tan(half) * std::min(1.0, double(scene.width) / scene.height));
  const Vec3 eye = centre + unit_or_zero(Vec3(0.35, 0.45, 1)) * (radius / std::sin(narrow));
  return look_at(eye, centre, Vec3(0, 1, 0), scene.camera.to_world);
}

Matrix rotation(const Vec3& axis, double degrees) {
  double sine = std::sin(degrees * std::numbers::pi / 180);
  double cosine = std::cos(degrees * std::numbers::pi / 180);
  if (const double quarters = degrees / 90; quarters == std::floor(quarters)) {
    const int turn = static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4));
    sine = turn == 1 ? 1 : turn == 3 ? -1 : 0;
    cosine = turn == 0 ? 1 : turn == 2 ? -1 : 0;
  }
  const Vec3 n = unit_or_zero(axis);
  Matrix matrix;  // row vectors: the transpose of Rodrigues' matrix
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) matrix[i][j] = n[i] * n[j] * (1 - cosine) + (i == j ? cosine : 0);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    matrix[i][j] += n[k] * sine;
    matrix[j][i] -= n[k] * sine;
  }
  return matrix;
}

Matrix from_rows(const std::array<double, 16>& rows) {
  Matrix matrix;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) matrix[j][i] = rows[4 * i + j];
  return matrix;
}

std::array<double, 16> to_rows(const Matrix& matrix) {
  std::array<double, 16> rows;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) rows[4 * i + j] = matrix[j][i] == 0 ? 0 : matrix[j][i];
  return rows;
}

}  // namespace castray
