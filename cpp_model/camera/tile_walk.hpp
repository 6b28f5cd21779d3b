// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/camera/tile_walk.sv: the order of tiles over a window, and of pixels in a tile.
#pragma once
#include <algorithm>

#include "fixed.hpp"

namespace castray {

// The even bits of a Z code, packed: its column. Its row is that of code >> 1.
constexpr int z_column(std::uint32_t code) {
  int column = 0;
  for (int bit = 0; bit < 16; ++bit) column |= static_cast<int>((code >> (2 * bit)) & 1) << bit;
  return column;
}

// visit(tile) for each tile of the job's window, which is not empty, in order.
template <class Visit> void for_each_tile(const job_t& job, int tile_log2, int slots, Visit&& visit) {
  const int first_column = static_cast<int>(job.x0) >> tile_log2, first_row = static_cast<int>(job.y0) >> tile_log2;
  const int columns = ((static_cast<int>(job.x1) - 1) >> tile_log2) - first_column + 1;
  const int rows = ((static_cast<int>(job.y1) - 1) >> tile_log2) - first_row + 1;
  int slot = 0;

  const auto tile_at = [&](int column, int row) {
    const auto clip = [&](int index, std::uint64_t low, std::uint64_t high, pixel_t& first, std::uint64_t& size) {
      first = std::max(static_cast<std::uint64_t>(index) << tile_log2, low);
      size = std::min(static_cast<std::uint64_t>(index + 1) << tile_log2, high) - first;
    };
    tile_t tile;
    clip(first_column + column, job.x0, job.x1, tile.x, tile.width);
    clip(first_row + row, job.y0, job.y1, tile.y, tile.height);
    tile.slot = static_cast<std::uint64_t>(slot);
    slot = slot + 1 == slots ? 0 : slot + 1;
    visit(tile);
  };

  if (job.z_order) {
    const std::uint32_t side = std::bit_ceil(static_cast<std::uint32_t>(std::max(columns, rows)));
    for (std::uint32_t code = 0; code < side * side; ++code) {
      const int column = z_column(code), row = z_column(code >> 1);
      if (column < columns && row < rows) tile_at(column, row);
    }
  } else {
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) tile_at(column, row);
  }
}

// visit(tag) for each pixel of a tile, row by row.
template <class Visit> void for_each_pixel(const tile_t& tile, Visit&& visit) {
  for (std::uint64_t y = tile.y; y < tile.y + tile.height; ++y)
    for (std::uint64_t x = tile.x; x < tile.x + tile.width; ++x) {
      pixel_tag_t tag;
      tag.x = x;
      tag.y = y;
      tag.slot = tile.slot;
      visit(tag);
    }
}

// visit(tag) for each pixel of the window, in the order of the walk.
template <class Visit> void tile_walk(const job_t& job, int tile_log2, int slots, Visit&& visit) {
  for_each_tile(job, tile_log2, slots, [&](const tile_t& tile) { for_each_pixel(tile, visit); });
}

}  // namespace castray
