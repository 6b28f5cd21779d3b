// SPDX-License-Identifier: Apache-2.0
// Words of the scene file, in the order of their enumerations.
#pragma once
#include <cstdio>
#include <string>

#include "scene/scene.hpp"

namespace castray {

inline constexpr const char* kMaterials[] = {"checker", "a", "b"};
inline constexpr const char* kPixelFormats[] = {"rgba8", "bgra8"};

inline std::string hex(const Rgb& rgb) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  return text;
}

}  // namespace castray
