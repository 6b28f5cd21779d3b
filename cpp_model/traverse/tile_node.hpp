// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/tile_node.sv: the parts of a tile's frontier as nodes, on one grid.
#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "fixed.hpp"

namespace castray {

struct TileNodes {
  std::array<node_t, 2> node;
  std::size_t count = 0;
};

// Up to four parts a node, in their order; planes rounded outward on the smallest spacings with which
// all parts lie on a node's grid from their least corner.
inline TileNodes tile_nodes(std::span<const part_t> parts) {
  TileNodes nodes;
  nodes.count = (parts.size() + 3) / 4;
  node_t grid;
  const auto axis = [&](coord_t point_t::*component, coord_t node_t::*origin, plane_exp_t node_t::*exp) {
    coord_t least = ~coord_t{0}, most = 0;
    for (const part_t& part : parts) {
      least = std::min(least, part.box.low.*component);
      most = std::max(most, part.box.high.*component);
    }
    grid.*origin = least;
    while (((most - least) >> (grid.*exp)) > 254) ++(grid.*exp);
  };
  axis(&point_t::x, &node_t::x, &node_t::exp_x);
  axis(&point_t::y, &node_t::y, &node_t::exp_y);
  axis(&point_t::z, &node_t::z, &node_t::exp_z);

  const auto low = [](coord_t p, coord_t origin, plane_exp_t exp) { return (p - origin) >> exp; };
  const auto high = [](coord_t p, coord_t origin, plane_exp_t exp) {
    const coord_t mask = (coord_t{1} << exp) - 1;
    return ((p - origin) >> exp) + (((p - origin) & mask) != 0);
  };
  nodes.node.fill(grid);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    node_t& node = nodes.node[i / 4];
    child_box_t* const boxes[] = {&node.box0, &node.box1, &node.box2, &node.box3};
    ref_word_t* const refs[] = {&node.ref0, &node.ref1, &node.ref2, &node.ref3};
    const box_t& box = parts[i].box;
    child_box_t& planes = *boxes[i % 4];
    planes.x0 = low(box.low.x, grid.x, grid.exp_x), planes.x1 = high(box.high.x, grid.x, grid.exp_x);
    planes.y0 = low(box.low.y, grid.y, grid.exp_y), planes.y1 = high(box.high.y, grid.y, grid.exp_y);
    planes.z0 = low(box.low.z, grid.z, grid.exp_z), planes.z1 = high(box.high.z, grid.z, grid.exp_z);
    *refs[i % 4] = parts[i].target.kind << LineW | parts[i].target.index;
  }
  return nodes;
}

}  // namespace castray
