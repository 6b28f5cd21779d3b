// SPDX-License-Identifier: Apache-2.0
// What a frame and the trace of one of its rays share: where a tile's rays start, and a hit's colour.
#pragma once
#include "loaded.hpp"
#include "shade/shade.hpp"

namespace castray {

inline shaded_t colour_of(const hit_t& hit, const Loaded& loaded, const Windows& windows) {
  if (!hit.found) return background(hit, loaded.paint);
  return shade(hit, load_attr(windows.image.data(), loaded.header, hit.number), loaded.camera.eye, loaded.paint);
}

// read(index) is told of each node of the image that is read.
template <class Read>
TileStart start_tile(const tile_t& tile, const job_t& job, const Loaded& loaded, const Windows& windows, Read&& read) {
  if (job.brute || job.from_root) return {.start = TileRoot};
  const Tree tree{.image = windows.image.data(), .header = &loaded.header, .limit = job.steps};
  return tile_start(tile, loaded.camera, tree.root().first, [&](line_t index, node_t& node) {
    read(index);
    if (index >= loaded.header.nodes.count) return false;
    node = load_node(windows.image.data(), loaded.header, index);
    return true;
  });
}

}  // namespace castray
