// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "scene/camera.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_names.hpp"

namespace castray {

std::string scene_text(const Scene& scene, const std::filesystem::path& folder) {
  nlohmann::ordered_json json;
  if (!scene.description.empty()) json["description"] = scene.description;
  json["size"] = {scene.width, scene.height};
  json["camera"]["camera_to_world"] = to_rows(scene.camera.to_world);
  json["camera"]["field_of_view"] = scene.camera.field_of_view;
  json["background"] = hex(scene.paint.background);
  json["checker"]["colours"] = {hex(scene.paint.colour_a), hex(scene.paint.colour_b)};
  json["checker"]["scale"] = scene.paint.checker_scale;
  json["pixel_format"] = kPixelFormats[static_cast<int>(scene.pixel_format)];
  json["meshes"] = nlohmann::ordered_json::array();
  const auto from = std::filesystem::absolute(folder.empty() ? "." : folder).lexically_normal();
  for (const MeshSource& mesh : scene.meshes) {
    const auto absolute = std::filesystem::absolute(mesh.file).lexically_normal();
    const auto relative = absolute.lexically_relative(from);
    json["meshes"].push_back({{"file", (relative.empty() ? absolute : relative).generic_string()},
                              {"object_to_world", to_rows(mesh.object_to_world)},
                              {"material", kMaterials[static_cast<int>(mesh.material)]}});
  }
  json["spheres"] = nlohmann::ordered_json::array();
  for (const Sphere& sphere : scene.spheres)
    json["spheres"].push_back({{"centre", {sphere.centre.x, sphere.centre.y, sphere.centre.z}},
                               {"radius", sphere.radius},
                               {"material", kMaterials[static_cast<int>(sphere.material)]}});
  try {
    return json.dump(2) + "\n";
  } catch (const nlohmann::json::type_error&) {
    throw SceneError(scene.file, "meshes", "a file name that is not UTF-8 cannot stand in a scene file");
  }
}

}  // namespace castray
