// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/camera/frame_setup.sv: the camera of a frame from its frame record.
#pragma once
#include "fixed.hpp"

namespace castray {

// One step vector: the product has 74 fraction bits and is rounded to DirFrac; then its sign.
constexpr std::int64_t scale_step(std::uint64_t scale, std::int64_t element, bool negate) {
  const int128 product = static_cast<int128>(low_bits(scale, ScaleFrac)) * element;
  const auto step = static_cast<std::int64_t>(round_shift(product, static_cast<int>(ScaleFrac + RotFrac - DirFrac)));
  return negate ? -step : step;
}

inline camera_t frame_setup(const frame_record_t& record) {
  const auto vector = [](std::uint64_t scale, std::int64_t x, std::int64_t y, std::int64_t z, bool negate) {
    dir_step3_t step;
    step.x = scale_step(scale, x, negate);
    step.y = scale_step(scale, y, negate);
    step.z = scale_step(scale, z, negate);
    return step;
  };
  const std::uint64_t coord_mask = (std::uint64_t{1} << CoordW) - 1;
  camera_t camera;
  camera.eye.x = record.eye_x & coord_mask;
  camera.eye.y = record.eye_y & coord_mask;
  camera.eye.z = record.eye_z & coord_mask;
  camera.right = vector(record.pitch, record.right_x, record.right_y, record.right_z, false);
  camera.up = vector(record.pitch, record.up_x, record.up_y, record.up_z, false);
  camera.ahead = vector(record.focal, record.back_x, record.back_y, record.back_z, true);
  camera.width = low_bits(record.width, extent_t_bits);
  camera.height = low_bits(record.height, extent_t_bits);
  return camera;
}

}  // namespace castray
