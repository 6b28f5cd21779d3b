// SPDX-License-Identifier: Apache-2.0
// An STL file, looked at before assimp reads it: assimp takes a text that is cut short for a smaller mesh.
#pragma once
#include <string>

namespace castray {

// Throws SceneError when a text does not end with endsolid.
void check_stl(const std::string& bytes, const std::string& file);

}  // namespace castray
