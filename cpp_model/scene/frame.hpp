// SPDX-License-Identifier: Apache-2.0
// The frame record of a scene's camera and paint.
#pragma once
#include "castray_records.hpp"
#include "scene/grid.hpp"
#include "scene/scene.hpp"

namespace castray {

// A pixel's direction in the camera's axes is (a pitch, b pitch, -focal), a = 2x + 1 - width,
// b = height - 2y - 1; focal / pitch = height / tan(half the field of view). The larger of focal and
// pitch max(width, height) lies in [1/2, 1), and pitch is a power of two: only focal is rounded.
// The matrix is scaled by a power of two so that its largest element lies in (1/2, 1]: directions
// have no length.
// Throws SceneError when size, field of view, matrix or eye are out of range.
frame_record_t frame_record(const Scene& scene, const Grid& grid, int width, int height);

}  // namespace castray
