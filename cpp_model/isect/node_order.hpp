// SPDX-License-Identifier: Apache-2.0
// The children that are visited, sorted, with the least t of each. RTL: rtl/isect/node_order.sv, equal
// bit for bit.
#pragma once
#include "isect/slab_planes.hpp"

namespace castray {

// The upper bits of a t.
inline dist_t dist_of(t_t t) { return t < 0 ? 0 : static_cast<dist_t>(t >> (CoordW + TFrac - DistW)); }

// The least t, margin included, of what lies `tick` ticks from the plane at dz, or behind it; rounded down.
inline dist_t dist_of_tick(std::int64_t dz, int ez, bool neg, std::int64_t tick) {
  constexpr int kUnit = CoordW - DistW - DistFrac;
  const std::int64_t plane = neg ? ((dz + BoxMargin) >> kUnit) + 1 : (dz - BoxMargin) >> kUnit;
  const std::int64_t z = plane + ((tick << ez) >> (SubPlane + kUnit));
  return static_cast<dist_t>(std::clamp<std::int64_t>((neg ? ~z : z) >> DistFrac, 0, (std::int64_t{1} << DistW) - 1));
}

struct child_t {
  bool exists = false;
  span_ticks_t inside;   // where the ray is inside the child's box
  ref_t target;
};

// By the tick at which the ray enters, then by the child's number.
inline visits_t node_order(const std::array<child_t, 4>& children, const span_ticks_t& limits, std::int64_t dz, int ez, bool neg) {
  const auto visited = [&](const child_t& c) {
    return c.exists && !c.inside.none && !limits.none && c.inside.low <= c.inside.high &&
           c.inside.low <= limits.high && c.inside.high >= limits.low;
  };
  const auto entered = [&](const child_t& c) { return neg ? kTickMax - c.inside.high : c.inside.low; };
  visits_t visits;
  entry_t* const entries[] = {&visits.e0, &visits.e1, &visits.e2, &visits.e3};
  for (int i = 0; i < 4; ++i) {
    const child_t& child = children[i];
    if (!visited(child)) continue;
    int place = 0;
    for (int j = 0; j < 4; ++j)
      if (j != i && visited(children[j]))
        place += entered(children[j]) < entered(child) || (j < i && entered(children[j]) == entered(child));
    *entries[place] = {.target = child.target, .least = dist_of_tick(dz, ez, neg, neg ? child.inside.high : child.inside.low)};
  }
  return visits;
}

}  // namespace castray
