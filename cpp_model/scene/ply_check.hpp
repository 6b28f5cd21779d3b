// SPDX-License-Identifier: Apache-2.0
// A PLY file, looked at before assimp reads it: assimp reads a header without end for ever, reserves memory for as
// many elements and corners as are announced, and of a text that is cut short reads its last lines again.
#pragma once
#include <string>

namespace castray {

// Throws SceneError when the header does not end, or announces more than follows it. What does not begin as a
// PLY file is left to assimp to refuse.
void check_ply(const std::string& bytes, const std::string& file);

}  // namespace castray
