// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/camera/ray_gen.sv: the direction through a pixel's centre, exact in Q3.42.
#pragma once
#include "fixed.hpp"

namespace castray {

inline dir_t ray_gen(const camera_t& camera, int x, int y) {
  const std::int64_t a = 2 * x + 1 - static_cast<std::int64_t>(camera.width);
  const std::int64_t b = static_cast<std::int64_t>(camera.height) - 2 * y - 1;
  const auto component = [&](std::int64_t ahead, std::int64_t right, std::int64_t up) {
    return wrap_signed(ahead + a * right + b * up, dir_comp_t_bits);
  };
  dir_t dir;
  dir.x = component(camera.ahead.x, camera.right.x, camera.up.x);
  dir.y = component(camera.ahead.y, camera.right.y, camera.up.y);
  dir.z = component(camera.ahead.z, camera.right.z, camera.up.z);
  return dir;
}

}  // namespace castray
