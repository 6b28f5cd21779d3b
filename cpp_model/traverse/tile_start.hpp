// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/tile_start.sv: where the rays of a tile start.
#pragma once
#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "traverse/frontier.hpp"
#include "traverse/tile_bounds.hpp"
#include "traverse/tile_node.hpp"

namespace castray {

struct TileStart {
  tile_bounds_t bounds;
  std::uint64_t start = 0;    // TileEmpty, TileRoot, TileOne or TileTwo
  TileNodes nodes;            // of the frontier
  int read = 0;               // nodes of the image
  error_t error = ErrNone;
};

// Where a ray of a tile starts; the model numbers the nodes of each tile's frontier from 0.
inline start_t start_of(std::uint64_t tile_start, const ref_t& root) {
  start_t start;
  if (tile_start == static_cast<std::uint64_t>(TileRoot)) {
    start.first = root;
  } else if (tile_start != static_cast<std::uint64_t>(TileEmpty)) {
    start.first.kind = RefTile;
    if (tile_start == static_cast<std::uint64_t>(TileTwo)) start.second = {.index = 1, .kind = RefTile};
  }
  return start;
}

template <class NodeAt> TileStart tile_start(const tile_t& tile, const camera_t& camera, const ref_t& root, NodeAt&& node_at) {
  CornerRays corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int x = static_cast<int>(tile.x + (i % 2 ? tile.width - 1 : 0)), y = static_cast<int>(tile.y + (i / 2 ? tile.height - 1 : 0));
    corners[i] = ray_setup(ray_gen(camera, x, y), camera, pixel_tag_t{});
  }
  TileStart out;
  out.bounds = tile_bounds(corners);
  const Frontier parts = frontier(out.bounds, camera.eye, root, node_at);
  out.read = parts.nodes;
  out.error = parts.error;
  out.start = static_cast<std::uint64_t>(parts.at_root ? TileRoot : parts.parts.empty() ? TileEmpty : parts.parts.size() <= 4 ? TileOne : TileTwo);
  if (!parts.at_root && !parts.parts.empty()) out.nodes = tile_nodes(parts.parts);
  return out;
}

}  // namespace castray
