// SPDX-License-Identifier: Apache-2.0
// A mesh of polygons as its file has it, and its way into a scene.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace castray {

struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> face_sizes;  // corners of each face, at least three
  std::vector<std::uint32_t> corners;     // a point for each corner, face by face
  std::vector<Vec3> normals;              // one for each corner, of any length; or none at all
  std::vector<Vec2> tex;                  // one for each corner, or none at all
  std::vector<std::string> warnings;
};

// Adds the mesh's triangles: a face of corners 0 .. n-1 becomes the fan (0, k, k+1). Points by the
// matrix, normals by its inverse transpose; where the matrix mirrors, each triangle's last two
// corners change places, so that what was outside stays outside. Without normals the face's serve,
// without texture coordinates zeros. Degenerate triangles are counted and left out.
void add_mesh(Scene& scene, const Mesh& mesh, const Matrix& object_to_world, Material material, const std::string& file);

// Throws SceneError unless x is finite and within the range of coordinates, +-2^60.
void check_coordinate(double x, const std::string& file, const std::string& place);

}  // namespace castray
