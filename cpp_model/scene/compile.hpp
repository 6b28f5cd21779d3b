// SPDX-License-Identifier: Apache-2.0
// Compiles a scene to the scene image: the bytes that the core and its model read.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "castray_records.hpp"
#include "scene/grid.hpp"
#include "scene/list_ray.hpp"
#include "scene/scene.hpp"
#include "scene/scene_image.hpp"

namespace castray {

// The records of an image before they are laid out in bytes.
struct ImageRecords {
  Grid grid;
  std::vector<prim_slot_t> slots;
  std::vector<attr_t> attributes;   // by number
  frame_record_t frame;
};
ImageRecords image_records(const Scene& scene, int width, int height);

// The finest grid on which scene and camera fit, the primitives, attributes and frame record.
// Throws SceneError when a number is out of range, or the frame's size is not 1 to MaxFrameSize.
SceneImage compile(const Scene& scene, int width, int height);
// The same for a list of rays: their origins take the camera's place, and the frame record stays zero.
SceneImage compile(const Scene& scene, std::span<const ListRay> rays);

// Distance in scene units of a hit record's t at a pixel.
double scene_distance(const SceneImage& image, int x, int y, std::int64_t t);

}  // namespace castray
