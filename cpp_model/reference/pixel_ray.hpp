// SPDX-License-Identifier: Apache-2.0
// The ray through a pixel's centre in double, from the scene alone. Not of unit length: its component
// along the camera's axis is one.
#pragma once
#include <cmath>
#include <numbers>

#include "scene/scene.hpp"

namespace castray {

inline Vec3 pixel_direction(const Scene& scene, int width, int height, int x, int y) {
  const double tangent = std::tan(scene.camera.field_of_view * std::numbers::pi / 360);
  const double across = (2 * (x + 0.5) / width - 1) * tangent * (double(width) / height);
  const double above = (1 - 2 * (y + 0.5) / height) * tangent;
  return scene.camera.right() * across + scene.camera.up() * above - scene.camera.back();
}

}  // namespace castray
