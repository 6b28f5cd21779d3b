// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/frontier.sv: the parts of the scene that the rays of a tile may meet, at most
// eight, from the root down.
#pragma once
#include <deque>
#include <vector>

#include "traverse/node_parts.hpp"
#include "traverse/tile_box.hpp"

namespace castray {

struct Frontier {
  bool at_root = false;        // the tile's rays start at the root
  std::vector<part_t> parts;   // else there
  int nodes = 0;               // read
  error_t error = ErrNone;
};

// node_at(index, node) reads a node of the image; false: there is none.
// A part that is a node waits. The first that waits is replaced by those of its children that the
// tile may meet, if there is room for them; else it stays. This ends when none waits.
template <class NodeAt>
Frontier frontier(const tile_bounds_t& bounds, const point_t& eye, const ref_t& root, NodeAt&& node_at) {
  const auto is = [](const ref_t& ref, std::int64_t kind) { return ref.kind == static_cast<std::uint64_t>(kind); };
  Frontier out;
  out.at_root = !bounds.valid || !is(root, RefNode);
  if (out.at_root) return out;
  std::deque<part_t> waiting(1);
  waiting[0].target = root;
  while (!waiting.empty() && out.error == ErrNone) {
    if (out.nodes == TileReads) {
      out.at_root = true;
      break;
    }
    const part_t head = waiting.front();
    waiting.pop_front();
    ++out.nodes;
    node_t node;
    if (!node_at(head.target.index, node) || !parts_legal(node, head.target.index)) {
      out.error = ErrNode;
      break;
    }
    std::vector<part_t> met;
    for (int child = 0; child < 4; ++child) {
      const part_t part = node_part(node, child);
      if (!is(part.target, RefNone) && tile_box(bounds, eye, part.box)) met.push_back(part);
    }
    if (out.parts.size() + waiting.size() + met.size() > TileParts) {
      out.parts.push_back(head);
    } else {
      for (const part_t& part : met)
        if (is(part.target, RefLeaf)) out.parts.push_back(part);
        else waiting.push_back(part);
    }
  }
  return out;
}

}  // namespace castray
