// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh.hpp"

#include <algorithm>
#include <cmath>

#include "scene/text.hpp"
#include "scene/vectors.hpp"

namespace castray {

void check_coordinate(double x, const std::string& file, const std::string& place) {
  if (!std::isfinite(x)) throw SceneError(file, place, text_of(x) + " is not a finite number");
  if (std::abs(x) > kLargestCoordinate) throw SceneError(file, place, text_of(x) + " is " + kOutside);
}

void add_mesh(Scene& scene, const Mesh& mesh, const Matrix& object_to_world, Material material, const std::string& file) {
  Matrix normal_to_world = object_to_world;
  normal_to_world[3][0] = normal_to_world[3][1] = normal_to_world[3][2] = 0;
  const double determinant = normal_to_world.determinant();
  if (!(std::abs(determinant) > 0) || !std::isfinite(determinant))
    throw SceneError(file, "object_to_world", "the matrix is singular");
  normal_to_world = normal_to_world.inverse().transposed();
  const bool mirrors = determinant < 0;

  std::vector<Vec3> points(mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) check_coordinate(mesh.points[i][axis], file, "point " + std::to_string(i));
    object_to_world.multVecMatrix(mesh.points[i], points[i]);
    for (int axis = 0; axis < 3; ++axis) check_coordinate(points[i][axis], file, "point " + std::to_string(i) + ", transformed");
  }

  std::size_t dropped = 0;
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    for (std::size_t k = 1; k + 1 < size; ++k) {
      std::array<std::size_t, 3> at = {first, first + k, first + k + 1};
      if (mirrors) std::swap(at[1], at[2]);
      Triangle triangle;
      triangle.material = material;
      for (int i = 0; i < 3; ++i) triangle.corner[i] = points[mesh.corners[at[i]]];
      triangle.face = unit_or_zero((triangle.corner[1] - triangle.corner[0]).cross(triangle.corner[2] - triangle.corner[0]));
      if (triangle.face == Vec3(0)) {
        ++dropped;
        continue;
      }
      for (int i = 0; i < 3; ++i) {
        triangle.normal[i] = triangle.face;
        if (!mesh.normals.empty()) {
          Vec3 turned;
          normal_to_world.multDirMatrix(unit_or_zero(mesh.normals[at[i]]), turned);
          triangle.normal[i] = unit_or_zero(turned);
        }
        if (!mesh.tex.empty()) triangle.tex[i] = mesh.tex[at[i]];
      }
      scene.triangles.push_back(triangle);
    }
    first += size;
  }

  for (const std::string& warning : mesh.warnings) scene.warnings.push_back(warning);
  if (dropped != 0) {
    scene.dropped_triangles += dropped;
    scene.warnings.push_back(file + ": " + counted(dropped, "degenerate triangle") + " dropped");
  }
}

}  // namespace castray
