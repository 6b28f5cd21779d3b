// SPDX-License-Identifier: Apache-2.0
// A box of whole grid steps, and the box of a primitive as a hierarchy needs it: padded by what the
// core's rounding can move a hit. docs/number-formats.md, "The margin of a box".
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "castray_records.hpp"

namespace castray {

struct Box {
  using Corner = std::array<std::int64_t, 3>;
  Corner low, high;

  Box() {
    low.fill(std::numeric_limits<std::int64_t>::max());
    high.fill(std::numeric_limits<std::int64_t>::min());
  }
  void add(const Corner& p) {
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  }
  void add(const Box& box) {
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], box.low[i]), high[i] = std::max(high[i], box.high[i]);
  }
  void pad(std::int64_t steps) {
    for (std::size_t i = 0; i < 3; ++i) low[i] -= steps, high[i] += steps;
  }
  bool holds(const Box& box) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (box.low[i] < low[i] || box.high[i] > high[i]) return false;
    return true;
  }
  // Half of the surface: in proportion to it rays meet the box.
  double half_area() const {
    const double x = double(high[0] - low[0]), y = double(high[1] - low[1]), z = double(high[2] - low[2]);
    return x * y + y * z + z * x;
  }
  bool operator==(const Box&) const = default;
};

// A reported point of a sphere lies no farther off its surface, on each axis, than kSphereSteps and a
// 2^kSphereShift-th of the radius: docs/number-formats.md, "The margin of a box".
inline constexpr int kSphereSteps = 6 + std::max(1, 1 << std::max<int>(HitDivW - BaryFrac - 3, 0));
inline constexpr int kSphereShift = [] {
  const auto bits = [](std::int64_t below) { return std::uint64_t{1} << (44 - below); };   // 2^-below in 44 fraction bits
  const std::uint64_t share = 5 * bits(ShearFrac) + bits(HitDivW - 3) + bits(BaryFrac - 2) + (HitDivW < ShearFrac ? bits(HitDivW - 2) : 0);
  return 44 - std::bit_width(share - 1);
}();
constexpr std::int64_t sphere_padding(std::int64_t radius) { return kSphereSteps + (radius >> kSphereShift); }

inline Box padded_box(const prim_slot_t& slot) {
  const auto corner = [](const point_t& p) { return Box::Corner{std::int64_t(p.x), std::int64_t(p.y), std::int64_t(p.z)}; };
  Box box;
  box.add(corner(slot.a));
  if (slot.kind == std::uint64_t{KindSphere}) {
    const auto radius = static_cast<std::int64_t>(slot.b.x);
    box.pad(radius + sphere_padding(radius));
  } else {
    box.add(corner(slot.b));
    box.add(corner(slot.c));
    box.pad(1);
  }
  return box;
}

}  // namespace castray
