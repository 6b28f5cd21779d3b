// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/shade/pixel_word.sv and rtl/shade/background.sv: a colour as a word of the frame buffer, and
// the colour of a miss.
#pragma once
#include "fixed.hpp"

namespace castray {

inline std::uint32_t pixel_word(const rgb_t& colour, bool swap_rb) {
  const std::uint64_t low = swap_rb ? colour.b : colour.r, high = swap_rb ? colour.r : colour.b;
  return static_cast<std::uint32_t>(low | colour.g << 8 | high << 16 | std::uint64_t{255} << 24);
}

inline shaded_t background(const hit_t& miss, const paint_t& paint) {
  shaded_t out;
  out.tag = miss.tag;
  out.colour = pixel_word(paint.background, paint.swap_rb);
  return out;
}

}  // namespace castray
