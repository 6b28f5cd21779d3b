// SPDX-License-Identifier: Apache-2.0
#include "scene/load.hpp"

#include <algorithm>
#include <cctype>

#include "scene/files.hpp"
#include "scene/scene_file.hpp"

namespace castray {

Scene load_scene(const std::filesystem::path& path, std::optional<FrameSize> size) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".json" ? read_scene_file(path, size) : mesh_scene(path, size);
}

void save_scene(const Scene& scene, const std::filesystem::path& path) { write_file(path, scene_text(scene, path.parent_path())); }

}  // namespace castray
