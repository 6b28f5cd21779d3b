// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/shade/paint.sv: texture times facing ratio. And rtl/shade/frame_paint.sv: the parameters.
#pragma once
#include <algorithm>

#include "fixed.hpp"
#include "shade/background.hpp"

namespace castray {

inline rgb_t rgb_of(std::uint64_t word) {
  rgb_t colour;
  colour.r = word & 255;
  colour.g = word >> 8 & 255;
  colour.b = word >> 16 & 255;
  return colour;
}

inline paint_t frame_paint(const frame_record_t& record) {
  paint_t paint;
  paint.background = rgb_of(record.background);
  paint.colour_a = rgb_of(record.colour_a);
  paint.colour_b = rgb_of(record.colour_b);
  paint.checker_scale = low_bits(record.checker_scale, checker_t_bits);
  paint.swap_rb = record.pixel_format == static_cast<std::uint64_t>(PixelBgra8);
  return paint;
}

constexpr std::int64_t kUnitOne = std::int64_t{1} << UnitFrac;

// |n . d|, zero to one, Q1.16.
inline std::int64_t facing_of(const unit3_t& n, const unit3_t& d) {
  const std::int64_t dot = round_shift(n.x * d.x + n.y * d.y + n.z * d.z, UnitFrac);
  return std::min(dot < 0 ? -dot : dot, kUnitOne);
}

// A unit vector's component as a texture coordinate: -1 to 1 becomes 0 to 1.
inline std::int64_t sphere_tex(std::int64_t n) { return (n + kUnitOne) >> 1; }

// Does the coordinate lie in an odd column of the checker?
inline bool odd_column(std::int64_t s, std::uint64_t scale) {
  return (s * static_cast<std::int64_t>(scale)) >> (UnitFrac + CheckerFrac) & 1;
}

inline bool is_colour_b(const paint_req_t& req, const paint_t& paint) {
  if (req.material == static_cast<std::uint64_t>(MaterialA)) return false;
  if (req.material == static_cast<std::uint64_t>(MaterialB)) return true;
  const bool sphere = req.kind == static_cast<std::uint64_t>(KindSphere);
  const std::int64_t s = sphere ? sphere_tex(req.normal.x) : req.s;
  const std::int64_t t = sphere ? sphere_tex(req.normal.y) : req.t;
  return odd_column(s, paint.checker_scale) != odd_column(t, paint.checker_scale);
}

inline shaded_t paint(const paint_req_t& req, const paint_t& paint) {
  const std::int64_t facing = facing_of(req.normal, req.view);
  const rgb_t full = is_colour_b(req, paint) ? paint.colour_b : paint.colour_a;
  const auto dim = [&](std::uint64_t c) {
    return static_cast<std::uint64_t>(round_shift(static_cast<std::int64_t>(c) * facing, UnitFrac));
  };
  rgb_t colour;
  colour.r = dim(full.r);
  colour.g = dim(full.g);
  colour.b = dim(full.b);
  shaded_t out;
  out.tag = req.tag;
  out.colour = pixel_word(colour, paint.swap_rb);
  return out;
}

}  // namespace castray
