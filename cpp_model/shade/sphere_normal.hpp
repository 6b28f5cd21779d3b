// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/shade/sphere_normal.sv: from a sphere's centre to the hit, in grid steps.
#pragma once
#include "fixed.hpp"
#include "isect/corner_delta.hpp"
#include "shade/interpolate.hpp"

namespace castray {

inline span3_t sphere_normal(const hit_t& hit, const point_t& centre, const point_t& eye) {
  const std::int64_t z = saturate_signed(round_shift(hit.neg ? -hit.t : hit.t, TFrac), CoordW + 1);
  using product_t = int_of<CoordW + ShearFrac + 3>;
  const auto at = [&](shear_t s) { return static_cast<std::int64_t>(round_shift(product_t{s} * z, ShearFrac)); };
  const delta3_t along = unpermute({at(hit.sx), at(hit.sy), z}, hit.axis);
  span3_t out;
  out.x = along.x + static_cast<std::int64_t>(eye.x) - static_cast<std::int64_t>(centre.x);
  out.y = along.y + static_cast<std::int64_t>(eye.y) - static_cast<std::int64_t>(centre.y);
  out.z = along.z + static_cast<std::int64_t>(eye.z) - static_cast<std::int64_t>(centre.z);
  return out;
}

}  // namespace castray
