// SPDX-License-Identifier: Apache-2.0
// Words of the scene file: values in the order of their enumerations, and the keys of each object.
#pragma once
#include <cstdio>
#include <string>

#include "scene/scene.hpp"

namespace castray {

inline constexpr const char* kMaterials[] = {"checker", "a", "b"};
inline constexpr const char* kPixelFormats[] = {"rgba8", "bgra8"};

inline constexpr const char* kSceneKeys[] = {"description", "size", "camera", "background", "checker", "pixel_format", "meshes", "spheres"};
inline constexpr const char* kCameraKeys[] = {"eye", "look_at", "up", "camera_to_world", "field_of_view"};
inline constexpr const char* kCheckerKeys[] = {"colours", "scale"};
inline constexpr const char* kMeshKeys[] = {"file", "object_to_world", "material"};
inline constexpr const char* kSphereKeys[] = {"centre", "radius", "material"};
inline constexpr const char* kStepKeys[] = {"translate", "rotate", "degrees", "scale", "flip"};

inline std::string hex(const Rgb& rgb) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  return text;
}

}  // namespace castray
