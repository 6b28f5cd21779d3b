// SPDX-License-Identifier: Apache-2.0
// One ray of a frame, stage by stage, and the start of its tile.
#pragma once
#include <vector>

#include "core.hpp"
#include "traverse/lane.hpp"

namespace castray {

struct RayTrace {
  std::vector<started_t> started;    // its tile
  // Nothing where a start is not sought (brute, from_root).
  std::vector<tile_bounds_t> bounds;
  std::vector<line_t> reads;         // nodes of the image
  std::vector<node_t> frontier;

  // None of a ray whose tile is empty.
  std::vector<pixel_dir_t> directions;
  std::vector<ray_t> rays;
  std::vector<Visit> visits;
  std::vector<prim_slot_t> tests;
  std::vector<cand_t> candidates;
  std::vector<result_t> results;

  pixel_tag_t tag;
  hit_t hit;
  shaded_t shaded;
};

// Of the ray through pixel (x, y) of the job's window, on tiles of 2^tile_log2 pixels a side. Throws std::runtime_error
// with the error code's number if the job is refused or the ray ends it.
RayTrace trace_pixel(const job_t& job, const Windows& windows, int x, int y, int tile_log2 = DefaultTileLog2);

}  // namespace castray
