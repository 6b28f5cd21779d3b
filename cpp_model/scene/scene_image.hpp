// SPDX-License-Identifier: Apache-2.0
// A scene as the bytes that the core and its model read: docs/scene-image.md.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "castray_records.hpp"

namespace castray {

struct Grid;

struct SceneImage {
  std::vector<std::uint8_t> bytes;
  image_header_t header;   // as in the bytes
  frame_record_t frame;    // as in the bytes
  std::size_t dropped_triangles = 0;  // degenerate on the grid: their numbers stay unused
  std::size_t dropped_spheres = 0;    // of radius zero on the grid
  std::vector<std::string> warnings;  // one line each

  double step() const;  // scene units of one grid step
  Grid grid() const;
};

// An image that was written to a file, byte for byte. Throws SceneError when it is none, is cut short, or is of another
// version or of other bit widths than this program.
SceneImage read_image(const std::filesystem::path& file);

}  // namespace castray
