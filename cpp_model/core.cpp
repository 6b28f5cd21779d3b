// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "camera/tile_walk.hpp"
#include "in_parallel.hpp"
#include "mem/hit_writer.hpp"
#include "of_frame.hpp"
#include "ray_list.hpp"

namespace castray {
namespace {

// A pixel into the frame and hit buffers.
void write_pixel(const hit_t& hit, const work_t& work, const job_t& job, const Loaded& loaded, const Windows& windows) {
  const std::uint32_t colour = static_cast<std::uint32_t>(colour_of(hit, loaded, windows).colour);
  std::memcpy(&windows.frame[hit.tag.y * loaded.record.stride + hit.tag.x * PixelBytes], &colour, PixelBytes);
  if (job.want_hits) store_record(&windows.hits[hit_offset(hit.tag, job.width)], hit_record(hit, job.want_work ? work : work_t{}));
}

// One tile into the frame and hit buffers.
Errors render_tile(const tile_t& tile, const job_t& job, const Loaded& loaded, const Windows& windows, bool every_error, WorkCounters& counters) {
  const TileStart start = start_tile(tile, job, loaded, windows, [](line_t) {});
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

}  // namespace castray
