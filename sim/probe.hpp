// SPDX-License-Identifier: Apache-2.0
// What passes inside the core for one pixel, for `castray ray`: stream_probe.sv, bound to the streams of the
// Verilated core, calls castray_probe for each item while a Probe is attached.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "fixed.hpp"
#include "traverse/lane.hpp"

namespace castray::sim {

class Probe {
 public:
  // Of pixel (x, y). in_tile: the job's window is the pixel's tile, the directions of whose corners come first; else it is this pixel
  // alone.
  Probe(int x, int y, bool in_tile) : x_(x), y_(y), corners_(in_tile ? 4 : 0) {}

  std::vector<tile_bounds_t> bounds;   // of the tile
  std::vector<line_t> reads;
  std::vector<node_t> frontier;
  std::vector<started_t> started;

  std::vector<pixel_dir_t> directions;
  std::vector<ray_t> rays;
  std::vector<Visit> visits;
  std::vector<prim_slot_t> tests;
  std::vector<cand_t> candidates;
  std::vector<result_t> results;
  std::vector<hit_t> hits;
  std::vector<shaded_t> shaded;

  // An item of a stream, by its number in stream_probe.sv.
  void take(int stream, const std::uint32_t* words);

  // Attached for as long as this object lives; one at a time.
  class Attached {
   public:
    explicit Attached(Probe& probe);
    ~Attached();
    Attached(const Attached&) = delete;
    Attached& operator=(const Attached&) = delete;
  };

  // Nothing is noted for as long as this object lives: registers without reset hold anything while
  // the core is reset, and what seems to pass then is no item.
  class Muted {
   public:
    Muted();
    ~Muted();
    Muted(const Muted&) = delete;
    Muted& operator=(const Muted&) = delete;
  };

 private:
  bool is_pixel(const pixel_tag_t& tag) const { return tag.x == x_ && tag.y == y_; }
  void enter(ctx_t ctx, const pixel_tag_t& tag);

  std::uint64_t x_, y_;
  int corners_;                // directions to come that are those of the tile's corners
  std::optional<ctx_t> ctx_;   // the context that holds the pixel's ray; all rays of the job are in one lane
};

}  // namespace castray::sim
