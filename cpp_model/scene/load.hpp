// SPDX-License-Identifier: Apache-2.0
// Reading scenes: a JSON scene file, or a mesh alone (.geo, .obj, .ply, .stl, .gltf, .glb).
#pragma once
#include <filesystem>
#include <optional>

#include "scene/scene.hpp"

namespace castray {

// Throws SceneError. A mesh alone gets a camera that frames it; Scene::defaults lists what was chosen.
// A size that is given stands in place of the scene's own: a camera that frames the scene heeds it.
Scene load_scene(const std::filesystem::path& path, std::optional<FrameSize> size = {});

// Writes the scene as JSON, every default filled in, mesh files relative to the written one.
// Throws SceneError; leaves no partial file behind.
void save_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace castray
