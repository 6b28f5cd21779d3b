// SPDX-License-Identifier: Apache-2.0
// A frame's rays as a list of rays.
#pragma once
#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "mem/ray_request.hpp"
#include "scene/compile.hpp"

namespace castray::sim {

// Of an image's frame, row by row.
inline std::vector<ray_record_t> camera_rays(const SceneImage& image) {
  const camera_t camera = frame_setup(image.frame);
  std::vector<ray_record_t> rays;
  for (int y = 0; y < static_cast<int>(camera.height); ++y)
    for (int x = 0; x < static_cast<int>(camera.width); ++x) rays.push_back(ray_record(camera.eye, ray_gen(camera, x, y)));
  return rays;
}

}  // namespace castray::sim
