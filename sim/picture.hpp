// SPDX-License-Identifier: Apache-2.0
// Pictures on disk, through OpenImageIO. Each is written under a temporary name and then moved to
// its place, so that a picture is whole or not there. All functions throw PictureError.
#pragma once
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "driver.hpp"
#include "reference/float64.hpp"

namespace castray::sim {

struct PictureError : std::runtime_error {
  using std::runtime_error::runtime_error;
  PictureError(const std::filesystem::path& file, const std::string& cause) : std::runtime_error(file.string() + ": " + cause) {}
};

// Red, green, blue of each pixel, row by row, top first.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

using Metadata = std::vector<std::pair<std::string, std::string>>;

Picture picture_of(const Rendering& rendering, PixelFormat format);
Picture picture_of(const ReferenceFrame& frame);

// The suffix says which format: .png and whatever else OpenImageIO writes with 8 bits a channel.
void write_picture(const std::filesystem::path& file, const Picture& picture, const Metadata& metadata);
Picture read_picture(const std::filesystem::path& file);

// EXR with 32-bit unsigned channels hit.t, hit.u, hit.v, hit.prim, hit.instance (the record's bits)
// and float channels t (distance in scene units, infinite for a miss), u, v, prim (-1 for a miss).
void write_aov(const std::filesystem::path& file, const Rendering& rendering, const SceneImage& image, const Metadata& metadata);
// The float channels alone.
void write_aov(const std::filesystem::path& file, const ReferenceFrame& frame, const Metadata& metadata);

// Fail now rather than after a long rendering if the file cannot be written: any, a picture of this size, an AOV.
void check_writable(const std::filesystem::path& file);
void check_picture(const std::filesystem::path& file, int width, int height);
void check_aov(const std::filesystem::path& file);

}  // namespace castray::sim
