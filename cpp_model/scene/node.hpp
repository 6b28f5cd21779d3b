// SPDX-License-Identifier: Apache-2.0
// A node and the boxes of its children, both ways.
#pragma once
#include <bit>
#include <span>
#include <vector>

#include "fixed.hpp"
#include "scene/box.hpp"

namespace castray {

// A reference word: kind and index.
constexpr std::uint64_t ref_word(std::int64_t kind, std::uint64_t index) { return static_cast<std::uint64_t>(kind) << LineW | index; }
constexpr std::int64_t ref_kind(std::uint64_t word) { return static_cast<std::int64_t>(word >> LineW); }
constexpr std::uint64_t ref_index(std::uint64_t word) { return word & ((std::uint64_t{1} << LineW) - 1); }

struct NodeChild {
  Box box;
  std::uint64_t word = 0;  // its reference
};

// A node's fields by axis and by child.
struct NodeFields {
  struct Planes {
    std::array<std::uint64_t*, 3> low, high;
    explicit Planes(child_box_t& b) : low{&b.x0, &b.y0, &b.z0}, high{&b.x1, &b.y1, &b.z1} {}
  };
  std::array<std::uint64_t*, 3> origin, exp;
  std::array<std::uint64_t*, 4> ref;
  std::array<Planes, 4> planes;
  explicit NodeFields(node_t& n)
      : origin{&n.x, &n.y, &n.z}, exp{&n.exp_x, &n.exp_y, &n.exp_z}, ref{&n.ref0, &n.ref1, &n.ref2, &n.ref3},
        planes{Planes(n.box0), Planes(n.box1), Planes(n.box2), Planes(n.box3)} {}
};

// One to four children: their planes on the finest power-of-two grid of 256 that covers them all on
// each axis, rounded outward.
inline node_t make_node(std::span<const NodeChild> children) {
  Box all;
  for (const NodeChild& child : children) all.add(child.box);
  node_t node;
  const NodeFields fields(node);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t origin = all.low[axis];
    const auto extent = static_cast<std::uint64_t>(all.high[axis] - origin);
    int exp = std::max(0, static_cast<int>(std::bit_width(extent)) - 8);
    const auto down = [&](std::int64_t p) { return static_cast<std::uint64_t>((p - origin) >> exp); };
    const auto up = [&](std::int64_t p) { return static_cast<std::uint64_t>((p - origin + (std::int64_t{1} << exp) - 1) >> exp); };
    if (up(all.high[axis]) > 255) ++exp;
    *fields.origin[axis] = static_cast<std::uint64_t>(origin);
    *fields.exp[axis] = static_cast<std::uint64_t>(exp);
    for (std::size_t i = 0; i < children.size(); ++i) {
      *fields.planes[i].low[axis] = down(children[i].box.low[axis]);
      *fields.planes[i].high[axis] = up(children[i].box.high[axis]);
    }
  }
  for (std::size_t i = 0; i < children.size(); ++i) *fields.ref[i] = children[i].word;
  return node;
}

// The children up to the first RefNone, with the boxes that the node's planes enclose.
inline std::vector<NodeChild> node_children(node_t node) {
  const NodeFields fields(node);
  std::vector<NodeChild> children;
  for (std::size_t i = 0; i < 4 && *fields.ref[i] != 0; ++i) {
    NodeChild& child = children.emplace_back();
    child.word = *fields.ref[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto plane = [&](std::uint64_t q) { return static_cast<std::int64_t>(*fields.origin[axis] + (q << *fields.exp[axis])); };
      child.box.low[axis] = plane(*fields.planes[i].low[axis]);
      child.box.high[axis] = plane(*fields.planes[i].high[axis]);
    }
  }
  return children;
}

}  // namespace castray
