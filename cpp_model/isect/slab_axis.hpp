// SPDX-License-Identifier: Apache-2.0
// Where a ray crosses a node's planes across an axis that is not dominant. RTL: rtl/isect/slab_axis.sv,
// equal bit for bit; docs/number-formats.md, "The test of a node", derives it.
#pragma once
#include <algorithm>

#include "fixed.hpp"

namespace castray {

// The ray crosses plane q between low + q mant and high + q (mant + 1), in this axis' ticks; minus:
// between low - q (mant + 1) and high - q mant.
struct slab_axis_t {
  bool minus;
  std::int64_t mant;   // 9 - SubPlane fraction bits
  slab_t low, high;
  int left;            // a tick of this axis is 2^left of the dominant one's; 15: or more
};

// d: the node's origin from the ray's; e: the exponent of the planes' spacing; dz, ez: those of the
// dominant axis.
inline slab_axis_t slab_axis(const recip_t& r, std::int64_t d, int e, std::int64_t dz, int ez) {
  constexpr int kDrop = RecipW - 1 - SubPlane;
  constexpr std::int64_t kEnd = std::int64_t{1} << (SubPlane + 10);
  const int exp = static_cast<int>(r.exp), over = e + exp - ez;
  const int right = over >= 0 ? e : ez - exp;

  const std::int64_t along = (dz << (RecipW - 1)) >> exp;
  const std::int64_t product = d * static_cast<std::int64_t>(r.mant) + (r.minus ? along : ~along);
  const std::int64_t base = std::clamp((product >> kDrop) >> right, -kEnd, kEnd - 1);
  const std::int64_t slack = (((d < 0 ? ~d : d) >> kDrop) >> right) + 1;
  const std::int64_t from = r.minus ? ~base : base;
  const bool before = (d < 0) != static_cast<bool>(r.minus);   // the true crossing lies before `from`

  slab_axis_t a;
  a.minus = r.minus;
  a.mant = static_cast<std::int64_t>(r.mant >> (RecipW - 10)) >> std::min(std::max(-over, 0), 31);
  a.low = before ? from - slack : from;
  a.high = before ? from + 1 : from + 1 + slack;
  a.left = std::clamp(over, 0, 15);
  return a;
}

}  // namespace castray
