// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh_file.hpp"

#include <algorithm>
#include <cctype>

#include "scene/files.hpp"
#include "scene/geo.hpp"
#include "scene/gltf_check.hpp"
#include "scene/import.hpp"
#include "scene/ply_check.hpp"
#include "scene/stl_check.hpp"

namespace castray {
namespace {

std::string extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& path) {
  const auto known = {".geo", ".obj", ".ply", ".stl", ".gltf", ".glb"};
  return std::find(known.begin(), known.end(), extension(path)) != known.end();
}

Mesh read_mesh(const std::filesystem::path& path) {
  if (!is_mesh_file(path))
    throw SceneError(path.string(), "file name", "unknown format \"" + extension(path) + "\"; known are .geo .obj .ply .stl .gltf .glb");
  if (extension(path) == ".geo") return read_geo(path);
  if (extension(path) == ".ply") check_ply(read_file(path), path.string());
  if (extension(path) == ".stl") check_stl(read_file(path), path.string());
  if (extension(path) == ".gltf" || extension(path) == ".glb") check_gltf(read_file(path), path.string());
  return import_mesh(path);
}

}  // namespace castray
