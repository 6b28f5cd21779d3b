// SPDX-License-Identifier: Apache-2.0
#include "ray_trace.hpp"

#include <stdexcept>

#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "camera/tile_walk.hpp"
#include "of_frame.hpp"

namespace castray {
namespace {

struct Watch {
  RayTrace& trace;
  void visit(const Visit& visit) { trace.visits.push_back(visit); }
  void test(const prim_slot_t& slot) { trace.tests.push_back(slot); }
};

tile_t tile_of(const job_t& job, int tile_log2, const pixel_tag_t& tag) {
  tile_t found;
  for_each_tile(job, tile_log2, 1, [&](const tile_t& tile) {
    if (tag.x - tile.x < tile.width && tag.y - tile.y < tile.height) found = tile;
  });
  return found;
}

void expect_none(error_t error) {
  if (error != ErrNone) throw std::runtime_error("the job ends with error " + std::to_string(error));
}

}  // namespace

RayTrace trace_pixel(const job_t& job, const Windows& windows, int x, int y, int tile_log2) {
  const Loaded loaded = load(job, windows);
  expect_none(loaded.error);
  RayTrace trace;
  trace.tag.x = static_cast<std::uint64_t>(x);
  trace.tag.y = static_cast<std::uint64_t>(y);

  const tile_t tile = tile_of(job, tile_log2, trace.tag);
  const TileStart start = start_tile(tile, job, loaded, windows, [&](line_t index) { trace.reads.push_back(index); });
  expect_none(start.error);
  if (!job.brute && !job.from_root) {
    trace.bounds = {start.bounds};
    trace.frontier.assign(start.nodes.node.begin(), start.nodes.node.begin() + static_cast<std::ptrdiff_t>(start.nodes.count));
  }
  trace.started = {{.tile = tile, .start = start.start}};

  if (start.start == static_cast<std::uint64_t>(TileEmpty)) {
    trace.hit.tag = trace.tag;
    trace.hit.t = TMax;
  } else {
    pixel_dir_t direction;
    direction.tag = trace.tag;
    direction.dir = ray_gen(loaded.camera, x, y);
    trace.directions = {direction};
    trace.rays = {slab_setup(ray_setup(direction.dir, loaded.camera, trace.tag))};
    WorkCounters counters;
    const auto accepted = [&](const cand_t& cand, const result_t* result) {
      trace.candidates.push_back(cand);
      if (result) trace.results.push_back(*result);
    };
    const TreeHit found = cast(trace.rays[0], job, loaded, windows, {start.start, trace.frontier}, counters, accepted, Watch{trace});
    expect_none(found.error);
    trace.hit = found.hit;
  }
  trace.shaded = colour_of(trace.hit, loaded, windows);
  return trace;
}

}  // namespace castray
