// SPDX-License-Identifier: Apache-2.0
// Exactly, in rational numbers: does the line of a ray pass through a box?
#pragma once
#include "isect/node_pipe.hpp"
#include "prim_cases.hpp"

namespace castray::tb {

struct Fraction {
  int128 num = 0, den = 1;  // den > 0
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.num * b.den < b.num * a.den; }
};

// A stretch of the line org + z (Sx, Sy, 1), as an interval of z; empty if first > last.
struct Stretch {
  Fraction first, last;
  bool empty = false;

  void clip(const Fraction& from, const Fraction& to) {
    if (first < from) first = from;
    if (to < last) last = to;
    if (last < first) empty = true;
  }
  // Where low <= s z <= high.
  void clip(shear_t s, std::int64_t low, std::int64_t high) {
    if (s == 0) {
      if (low > 0 || high < 0) empty = true;
      return;
    }
    const Fraction a{int128{s > 0 ? low : -low} * kOne, std::abs(s)}, b{int128{s > 0 ? high : -high} * kOne, std::abs(s)};
    s > 0 ? clip(a, b) : clip(b, a);
  }
};

// A box on axes permuted as the ray's, seen from its origin.
struct Box {
  delta3_t low, high;
};

inline Stretch inside(shear_t sx, shear_t sy, const Box& box) {
  Stretch z{{box.low.z}, {box.high.z}};
  if (box.low.z > box.high.z) z.empty = true;
  z.clip(sx, box.low.x, box.high.x);
  z.clip(sy, box.low.y, box.high.y);
  return z;
}

// The box of child i of a node.
inline const child_box_t& child_box(const node_t& node, int i) {
  const child_box_t* const boxes[] = {&node.box0, &node.box1, &node.box2, &node.box3};
  return *boxes[i];
}
inline ref_word_t child_ref(const node_t& node, int i) {
  const ref_word_t refs[] = {node.ref0, node.ref1, node.ref2, node.ref3};
  return refs[i];
}
inline Box box_of(const node_t& node, int i, const slab_ray_t& ray) {
  const child_box_t& b = child_box(node, i);
  const auto plane = [](coord_t from, plane_t q, plane_exp_t exp) { return static_cast<std::int64_t>(from + (q << exp)); };
  const auto corner = [&](plane_t x, plane_t y, plane_t z) {
    const delta3_t at = permute({plane(node.x, x, node.exp_x), plane(node.y, y, node.exp_y), plane(node.z, z, node.exp_z)}, ray.axis);
    const auto from = [](std::int64_t p, coord_t org) { return p - static_cast<std::int64_t>(org); };
    return delta3_t{from(at.x, ray.org.x), from(at.y, ray.org.y), from(at.z, ray.org.z)};
  };
  return {corner(b.x0, b.y0, b.z0), corner(b.x1, b.y1, b.z1)};
}

}  // namespace castray::tb
