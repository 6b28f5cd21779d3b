// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/node_visits.sv: from a reference to the children that a ray visits.
#pragma once
#include <span>

#include "isect/node_pipe.hpp"
#include "mem/image.hpp"

namespace castray {

// A child that is a node lies behind its parent.
inline bool children_behind(const node_t& node, line_t parent) {
  for (const ref_word_t word : {node.ref0, node.ref1, node.ref2, node.ref3}) {
    const std::uint64_t kind = word >> LineW, index = word & ((std::uint64_t{1} << LineW) - 1);
    if (kind == static_cast<std::uint64_t>(RefNode) && index <= parent) return false;
  }
  return true;
}

// `ref`: a node of the image, or one of a tile's frontier. t: the nearest hit so far. ErrNode: no visits.
inline error_t node_visits(const std::uint8_t* image, const image_header_t& header, std::span<const node_t> tile,
                           const ref_t& ref, const slab_ray_t& ray, t_t t, visits_t& visits) {
  bool illegal;
  if (ref.kind == static_cast<std::uint64_t>(RefTile)) {
    visits = node_pipe(ray, tile[ref.index], t, illegal);
  } else {
    if (ref.index >= header.nodes.count) return ErrNode;
    const node_t node = load_node(image, header, ref.index);
    if (!children_behind(node, ref.index)) return ErrNode;
    visits = node_pipe(ray, node, t, illegal);
  }
  return illegal ? ErrNode : ErrNone;
}

}  // namespace castray
