// SPDX-License-Identifier: Apache-2.0
// Meshes in OBJ, PLY, STL and glTF, through assimp.
#pragma once
#include <filesystem>

#include "scene/mesh.hpp"

namespace castray {

// All meshes of the file, placed by its nodes, as triangles. Throws SceneError.
Mesh import_mesh(const std::filesystem::path& path);

}  // namespace castray
