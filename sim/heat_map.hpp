// SPDX-License-Identifier: Apache-2.0
// Pictures of numbers: what was done for each pixel, from black (none) to yellow (most), and below it the
// scale with its ends.
#pragma once
#include <span>
#include <string>

#include "picture.hpp"

namespace castray::sim {

// values: one for each pixel, row by row, top first. caption: what they are, in the plural. Small frames are
// enlarged by a whole factor, so that the scale can be read. Throws PictureError.
void write_heat_map(const std::filesystem::path& file, int width, int height, std::span<const std::uint32_t> values,
                    const std::string& caption, const Metadata& metadata);

// Fails now if the heat map of a frame of this size cannot be written there.
void check_heat_map(const std::filesystem::path& file, int width, int height);

}  // namespace castray::sim
