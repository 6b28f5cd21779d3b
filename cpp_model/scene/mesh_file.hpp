// SPDX-License-Identifier: Apache-2.0
// A mesh file of any format, told by its extension.
#pragma once
#include <filesystem>

#include "scene/mesh.hpp"

namespace castray {

bool is_mesh_file(const std::filesystem::path& path);    // .geo, .obj, .ply, .stl, .gltf or .glb
Mesh read_mesh(const std::filesystem::path& path);       // throws SceneError

}  // namespace castray
