// SPDX-License-Identifier: Apache-2.0
// One child's box on all three axes. RTL: rtl/isect/slab_child.sv, equal bit for bit.
#pragma once
#include "isect/slab_planes.hpp"

namespace castray {

// The planes of a box on permuted axes.
struct slab_box_t {
  std::int64_t x0, x1, y0, y1, z0, z1;
};

// Where the ray is inside the box: nowhere if none, or low > high.
inline span_ticks_t slab_child(const slab_axis_t& x, const slab_axis_t& y, const slab_box_t& box) {
  const span_ticks_t on_x = slab_planes(x, box.x0, box.x1), on_y = slab_planes(y, box.y0, box.y1);
  return {on_x.none || on_y.none, std::max({on_x.low, on_y.low, box.z0 << SubPlane}),
          std::min({on_x.high, on_y.high, box.z1 << SubPlane})};
}

}  // namespace castray
