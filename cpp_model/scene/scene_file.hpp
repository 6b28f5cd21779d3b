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

#include "scene/scene.hpp"

namespace castray {

Scene read_scene_file(const std::filesystem::path& path);  // throws SceneError
Scene mesh_scene(const std::filesystem::path& path);       // the scene of one mesh, all else by default
std::string scene_text(const Scene& scene, const std::filesystem::path& folder);  // mesh files relative to folder

}  // namespace castray
