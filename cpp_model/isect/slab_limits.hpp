// SPDX-License-Identifier: Apache-2.0
// Where on a ray a hit may still be of use. RTL: rtl/isect/slab_limits.sv, equal bit for bit.
#pragma once
#include "isect/slab_planes.hpp"

namespace castray {

// Between tmin and t, moved apart by the margin of a box.
inline span_ticks_t slab_limits(t_t tmin, t_t t, bool neg, std::int64_t dz, int ez) {
  const std::int64_t from = (tmin >> TFrac) - BoxMargin, to = (t >> TFrac) + BoxMargin;
  const auto ticks = [&](std::int64_t z) { return ((z - dz) << SubPlane) >> ez; };
  const std::int64_t first = ticks(neg ? -to : from), last = ticks(neg ? -from : to);
  return {last < 0, std::clamp<std::int64_t>(first, 0, kTickMax), std::clamp<std::int64_t>(last, 0, kTickMax)};
}

}  // namespace castray
