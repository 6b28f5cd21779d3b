// SPDX-License-Identifier: Apache-2.0
#include "scene/frame.hpp"

#include <algorithm>
#include <numbers>

#include "scene/text.hpp"

namespace castray {
namespace {

std::uint64_t word(const Rgb& rgb) { return rgb[0] | std::uint64_t{rgb[1]} << 8 | std::uint64_t{rgb[2]} << 16 | 0xff000000u; }

void set_lens(frame_record_t& frame, const Scene& scene, int width, int height) {
  const double fov = scene.camera.field_of_view;
  if (!kFieldOfView.hold(fov)) throw SceneError(scene.file, "camera", "field of view of " + text_of(fov) + " degrees is not " + text_of(kFieldOfView));
  // Focal in units of the pitch, which is a power of two: only focal is rounded.
  const long double focal = height / std::tan(static_cast<long double>(fov) * std::numbers::pi_v<long double> / 360);
  const long double largest = std::max(focal, static_cast<long double>(std::max(width, height)));
  const int scale = ScaleFrac - 1 - std::ilogb(largest);
  frame.pitch = std::uint64_t{1} << scale;
  frame.focal = std::min(static_cast<std::uint64_t>(std::llround(std::ldexp(focal, scale))), (std::uint64_t{1} << ScaleFrac) - 1);
}

// The determinant of the rounded matrix, exactly: its products have 93 bits.
bool singular(const frame_record_t& f) {
  using Wide = __int128;
  const auto minor = [](rot_t a, rot_t b, rot_t c, rot_t d) { return Wide{a} * d - Wide{b} * c; };
  return f.right_x * minor(f.up_y, f.up_z, f.back_y, f.back_z) - f.right_y * minor(f.up_x, f.up_z, f.back_x, f.back_z) +
             f.right_z * minor(f.up_x, f.up_y, f.back_x, f.back_y) == 0;
}

void set_matrix(frame_record_t& frame, const Scene& scene) {
  const Vec3 columns[] = {scene.camera.right(), scene.camera.up(), scene.camera.back()};
  double largest = 0;
  for (const Vec3& column : columns)
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(column[i])) throw SceneError(scene.file, "camera", "the matrix is not finite");
      largest = std::max(largest, std::abs(column[i]));
    }
  if (largest == 0) throw SceneError(scene.file, "camera", "the matrix is zero");
  int shift = std::ilogb(largest);
  if (std::ldexp(largest, -shift) > 1 + 0x1p-32) ++shift;  // to the next power of two, but for its last bits
  rot_t* const fields[] = {&frame.right_x, &frame.right_y, &frame.right_z, &frame.up_x, &frame.up_y,
                           &frame.up_z,    &frame.back_x,  &frame.back_y,  &frame.back_z};
  for (int i = 0; i < 9; ++i) *fields[i] = std::llround(std::ldexp(columns[i / 3][i % 3], RotFrac - shift));
  if (singular(frame))
    throw SceneError(scene.file, "camera", "the matrix is singular in " + std::to_string(RotFrac) + " fraction bits: its axes are too unequal or too nearly parallel");
}

}  // namespace

frame_record_t frame_record(const Scene& scene, const Grid& grid, int width, int height) {
  if (!kFrameSize.hold(width) || !kFrameSize.hold(height)) {
    const auto square = [](double side) { return text_of(side) + " x " + text_of(side); };
    throw SceneError(scene.file, "size", std::to_string(width) + " x " + std::to_string(height) + " is not between " +
                                             square(kFrameSize.least) + " and " + square(kFrameSize.most));
  }
  frame_record_t frame;
  set_lens(frame, scene, width, height);
  set_matrix(frame, scene);

  std::uint64_t* const eye[] = {&frame.eye_x, &frame.eye_y, &frame.eye_z};
  for (int i = 0; i < 3; ++i) {
    const double x = scene.camera.eye()[i];
    const bool near = std::isfinite(x) && std::abs(std::ldexp(x, -grid.power)) < 0x1p60;
    if (!near || !Grid::holds(grid.at(x, i)))
      throw SceneError(scene.file, "camera", "the eye at " + text_of(x) + " lies outside the grid of the image");
    *eye[i] = static_cast<std::uint64_t>(grid.at(x, i));
  }

  frame.background = word(scene.paint.background);
  frame.colour_a = word(scene.paint.colour_a);
  frame.colour_b = word(scene.paint.colour_b);
  const double scale = scene.paint.checker_scale;
  if (!kCheckerScale.hold(scale)) throw SceneError(scene.file, "checker", "scale " + text_of(scale) + " is not " + text_of(kCheckerScale));
  frame.checker_scale = static_cast<std::uint64_t>(std::llround(std::ldexp(scale, CheckerFrac)));
  frame.width = static_cast<std::uint64_t>(width);
  frame.height = static_cast<std::uint64_t>(height);
  frame.pixel_format = static_cast<std::uint64_t>(scene.pixel_format);
  const int row = width * static_cast<int>(PixelBytes);
  frame.stride = static_cast<std::uint64_t>((row + BufferAlign - 1) / BufferAlign * BufferAlign);
  return frame;
}

}  // namespace castray
