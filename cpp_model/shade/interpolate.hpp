// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/shade/interpolate.sv: a triangle's normal and texture coordinates at a hit.
#pragma once
#include <algorithm>

#include "fixed.hpp"

namespace castray {

// x to the nearest value that `bits` signed bits hold.
constexpr std::int64_t saturate_signed(std::int64_t x, int bits) {
  const std::int64_t top = (std::int64_t{1} << (bits - 1)) - 1;
  return std::clamp(x, -top - 1, top);
}

// Weights of the corners a, b, c in Q2.16; their sum is exactly one.
struct weights_t {
  std::int64_t a = 0, b = 0, c = 0;
};
inline weights_t weights_of(bary_t u, bary_t v) {
  constexpr int drop = BaryFrac > UnitFrac ? BaryFrac - UnitFrac : 0, gain = BaryFrac > UnitFrac ? 0 : UnitFrac - BaryFrac;
  const auto weight = [](bary_t x) { return round_shift(static_cast<std::int64_t>(x), drop) << gain; };
  const std::int64_t wu = weight(u), wv = weight(v);
  return {wu, wv, (std::int64_t{1} << UnitFrac) - wu - wv};
}

// Fraction bits of a mixed normal beyond those of the corners'.
inline constexpr int kNormalKeep = 10;

// The weighted sum with `keep` of the UnitFrac fraction bits that the weights bring.
inline std::int64_t mix(const weights_t& w, std::int64_t a, std::int64_t b, std::int64_t c, int keep, int bits) {
  return saturate_signed(round_shift(w.a * a + w.b * b + w.c * c, static_cast<int>(UnitFrac) - keep), bits);
}

// Not normalised, Q3.26; zero where the corners' normals cancel.
inline span3_t mix_normal(const weights_t& w, const attr_t& attr) {
  span3_t out;
  out.x = mix(w, attr.na.x, attr.nb.x, attr.nc.x, kNormalKeep, span_t_bits);
  out.y = mix(w, attr.na.y, attr.nb.y, attr.nc.y, kNormalKeep, span_t_bits);
  out.z = mix(w, attr.na.z, attr.nb.z, attr.nc.z, kNormalKeep, span_t_bits);
  return out;
}

inline smooth_t interpolate(const attr_t& attr, bary_t u, bary_t v) {
  const weights_t w = weights_of(u, v);
  smooth_t out;
  out.normal = mix_normal(w, attr);
  if (out.normal == span3_t{}) {
    out.normal.x = attr.face.x << kNormalKeep;
    out.normal.y = attr.face.y << kNormalKeep;
    out.normal.z = attr.face.z << kNormalKeep;
  }
  out.s = mix(w, attr.sa, attr.sb, attr.sc, 0, tex_t_bits);
  out.t = mix(w, attr.ta, attr.tb, attr.tc, 0, tex_t_bits);
  return out;
}

}  // namespace castray
