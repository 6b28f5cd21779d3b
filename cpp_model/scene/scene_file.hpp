// SPDX-License-Identifier: Apache-2.0
// The scene file: JSON.
//   size [w, h] · camera {eye, look_at, up | camera_to_world; field_of_view} · background · checker
//   {colours [a, b], scale} · pixel_format · meshes [{file, object_to_world, material}] · spheres
//   [{centre, radius, material}] · description.
// A matrix is sixteen numbers row by row (translation in the last column), or a list of steps
// {translate [x, y, z]}, {rotate [axis], degrees}, {scale s | [x, y, z]}, {flip "x"}, applied in turn.
// Files are relative to the scene file; a key that is not known is an error.
#pragma once
#include <filesystem>
#include <optional>

#include "scene/scene.hpp"

namespace castray {

// Both throw SceneError. A size that is given stands in place of the scene's own.
Scene read_scene_file(const std::filesystem::path& path, std::optional<FrameSize> size);
Scene mesh_scene(const std::filesystem::path& path, std::optional<FrameSize> size);  // of one mesh, all else by default
// Mesh files relative to folder. Throws SceneError if one has a name that JSON cannot hold.
std::string scene_text(const Scene& scene, const std::filesystem::path& folder);

}  // namespace castray
