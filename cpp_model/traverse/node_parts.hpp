// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/node_parts.sv: a node's children as parts of the scene.
#pragma once
#include <algorithm>

#include "isect/node_pipe.hpp"
#include "traverse/node_visits.hpp"

namespace castray {

// Planes beyond the grid come from illegal images only, or from rounding outward: nothing lies there.
inline part_t node_part(const node_t& node, int child) {
  const ref_word_t words[] = {node.ref0, node.ref1, node.ref2, node.ref3};
  const child_box_t* const boxes[] = {&node.box0, &node.box1, &node.box2, &node.box3};
  const child_box_t& planes = *boxes[child];
  const auto at = [](coord_t origin, plane_t plane, plane_exp_t exp) {
    return std::min(origin + (plane << exp), (coord_t{1} << CoordFieldW) - 1);
  };
  part_t part;
  // A low plane above the high one: the box holds nothing.
  if (planes.x0 > planes.x1 || planes.y0 > planes.y1 || planes.z0 > planes.z1) return part;
  part.target.kind = words[child] >> LineW & 3;
  part.target.index = words[child] & ((std::uint64_t{1} << LineW) - 1);
  part.box.low = {.z = at(node.z, planes.z0, node.exp_z), .y = at(node.y, planes.y0, node.exp_y), .x = at(node.x, planes.x0, node.exp_x)};
  part.box.high = {.z = at(node.z, planes.z1, node.exp_z), .y = at(node.y, planes.y1, node.exp_y), .x = at(node.x, planes.x1, node.exp_x)};
  return part;
}

inline bool parts_legal(const node_t& node, line_t index) { return node_legal(node) && children_behind(node, index); }

}  // namespace castray
