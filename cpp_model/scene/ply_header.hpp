// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file, looked at before assimp reads it: assimp reads a header without end for
// ever, and reserves memory for as many elements as one announces.
#pragma once
#include <string>

namespace castray {

// Throws SceneError when the header does not end, or announces more elements than bytes follow it.
// What does not begin as a PLY file is left to assimp to refuse.
void check_ply_header(const std::string& bytes, const std::string& file);

}  // namespace castray
