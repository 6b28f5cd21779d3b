// SPDX-License-Identifier: Apache-2.0
// The .geo format: numbers over any white space.
//   number of faces; corners of each face; point of each corner; points, x y z each, as many as the
//   largest index + 1; normals, x y z each; texture coordinates, s t each.
// Normals come one for each corner, face or point, texture coordinates one for each corner or point:
// how many numbers follow the points says which.
#pragma once
#include <filesystem>

#include "scene/mesh.hpp"

namespace castray {

Mesh read_geo(const std::filesystem::path& path);                      // throws SceneError
Mesh parse_geo(const std::string& text, const std::string& file);      // file: for messages

// Normals and texture coordinates for each corner; points so that they read back exactly, the
// others to a hundred thousandth.
std::string geo_text(const Mesh& mesh);

}  // namespace castray
