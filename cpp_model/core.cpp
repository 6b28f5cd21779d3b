// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include <stdexcept>

#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "camera/tile_walk.hpp"
#include "in_parallel.hpp"
#include "mem/hit_writer.hpp"
#include "ray_list.hpp"
#include "shade/shade.hpp"
#include "traverse/tile_start.hpp"

namespace castray {
namespace {

shaded_t colour_of(const hit_t& hit, const Loaded& loaded, const Windows& windows) {
  if (!hit.found) return background(hit, loaded.paint);
  return shade(hit, load_attr(windows.image.data(), loaded.header, hit.number), loaded.camera.eye, loaded.paint);
}

pixel_tag_t tag_of(int x, int y) {
  pixel_tag_t tag;
  tag.x = static_cast<std::uint64_t>(x);
  tag.y = static_cast<std::uint64_t>(y);
  return tag;
}

// A pixel into the frame and hit buffers.
void write_pixel(const hit_t& hit, const work_t& work, const job_t& job, const Loaded& loaded, const Windows& windows) {
  const std::uint32_t colour = static_cast<std::uint32_t>(colour_of(hit, loaded, windows).colour);
  std::memcpy(&windows.frame[hit.tag.y * loaded.record.stride + hit.tag.x * PixelBytes], &colour, PixelBytes);
  if (job.want_hits) store_record(&windows.hits[hit_offset(hit.tag, job.width)], hit_record(hit, job.want_work ? work : work_t{}));
}

TileStart start_tile(const tile_t& tile, const job_t& job, const Loaded& loaded, const Windows& windows) {
  if (job.brute || job.from_root) return {.start = TileRoot};
  const Tree tree{.image = windows.image.data(), .header = &loaded.header, .limit = job.steps};
  return tile_start(tile, loaded.camera, tree.root().first, [&](line_t index, node_t& node) {
    if (index >= loaded.header.nodes.count) return false;
    node = load_node(windows.image.data(), loaded.header, index);
    return true;
  });
}

// One tile into the frame and hit buffers.
Errors render_tile(const tile_t& tile, const job_t& job, const Loaded& loaded, const Windows& windows, bool every_error, WorkCounters& counters) {
  const TileStart start = start_tile(tile, job, loaded, windows);
  counters.tile_nodes += static_cast<std::uint64_t>(start.read);
  Errors errors = start.error;
  const bool empty = start.start == static_cast<std::uint64_t>(TileEmpty);
  if (empty && start.error == ErrNone && !job.want_hits) ++counters.empty_tiles;
  for_each_pixel(tile, [&](const pixel_tag_t& tag) {
    if (start.error != ErrNone || (errors.first != ErrNone && !every_error)) return;
    TreeHit found;
    found.hit.tag = tag;
    if (!empty) {
      const ray_t ray = ray_setup(ray_gen(loaded.camera, static_cast<int>(tag.x), static_cast<int>(tag.y)), loaded.camera, tag);
      found = cast(slab_setup(ray), job, loaded, windows, {start.start, std::span(start.nodes.node).first(start.nodes.count)},
                   counters, [](const cand_t&, const result_t*) {});
    }
    errors += found.error;
    if (found.error == ErrNone) write_pixel(found.hit, found.work, job, loaded, windows);
  });
  return errors;
}

}  // namespace

Outcome run_job(const job_t& job, const Windows& windows, const RunOptions& options) {
  const Loaded loaded = load(job, windows);
  if (loaded.error != ErrNone) {
    Errors errors = loaded.error;
    if (job.is_list && loaded.error == ErrPrimitive) errors += ray_errors(job, windows);
    return {.error = errors.first, .errors = errors.all};
  }
  if (job.is_list) return run_list(job, loaded, windows, options);
  std::vector<tile_t> tiles;
  for_each_tile(job, options.tile_log2, 1, [&](const tile_t& tile) { tiles.push_back(tile); });
  return in_parallel(tiles.size(), options, [&](std::size_t i, WorkCounters& counters) {
    return render_tile(tiles[i], job, loaded, windows, options.every_error, counters);
  });
}

RayTrace trace_pixel(const job_t& job, const Windows& windows, int x, int y) {
  const Loaded loaded = load(job, windows);
  if (loaded.error != ErrNone) throw std::runtime_error("the job is refused with error " + std::to_string(loaded.error));
  RayTrace trace;
  WorkCounters counters;
  trace.tag = tag_of(x, y);
  trace.dir = ray_gen(loaded.camera, x, y);
  trace.ray = slab_setup(ray_setup(trace.dir, loaded.camera, trace.tag));
  const TreeHit found = cast(trace.ray, job, loaded, windows, {}, counters, [&](const cand_t& cand, const result_t* result) {
    trace.candidates.push_back(cand);
    if (result) trace.results.push_back(*result);
  });
  if (found.error != ErrNone) throw std::runtime_error("the ray ends the job with error " + std::to_string(found.error));
  trace.hit = found.hit;
  trace.shaded = colour_of(trace.hit, loaded, windows);
  trace.record = hit_record(trace.hit);
  return trace;
}

}  // namespace castray
