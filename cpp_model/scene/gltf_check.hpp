// SPDX-License-Identifier: Apache-2.0
// A glTF file, looked at before assimp reads it: assimp believes a .glb's lengths, and goes down brackets and
// nodes by recursion, as often as a node has parents.
#pragma once
#include <string>

namespace castray {

// Throws SceneError when a length of a .glb goes beyond the file, a node has two parents, or brackets or nodes are nested too
// deep. What does not look like glTF 2 is left to assimp to refuse.
void check_gltf(const std::string& bytes, const std::string& file);

}  // namespace castray
