// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "camera/tile_walk.hpp"
#include "mem/hit_writer.hpp"
#include "mem/image.hpp"
#include "mem/prim_reader.hpp"
#include "shade/paint.hpp"
#include "shade/shade.hpp"
#include "traverse/lane.hpp"
#include "traverse/tile_start.hpp"

namespace castray {
namespace {

// What is read from the image, and made of it, once a job.
struct Loaded {
  error_t error = ErrNone;
  image_header_t header;
  frame_record_t record;
  camera_t camera;
  paint_t paint;
  std::vector<prim_slot_t> slots;
};

Loaded load(const job_t& job, const Windows& windows) {
  Loaded loaded;
  loaded.error = check_image(windows.image.data(), windows.image.size(), job, loaded.header, loaded.record);
  if (loaded.error != ErrNone) return loaded;
  loaded.camera = frame_setup(loaded.record);
  loaded.paint = frame_paint(loaded.record);
  if (job.brute) {
    loaded.slots = read_slots(windows.image.data(), loaded.header);
    for (const prim_slot_t& slot : loaded.slots)
      if (!slot_ok(slot, loaded.header)) loaded.error = ErrPrimitive;
  }
  return loaded;
}

// Where the rays of a tile start, and the nodes of its frontier.
struct Started {
  std::uint64_t start = TileRoot;
  std::span<const node_t> nodes;
};

// A lane's work for one ray, and what it adds to the counters.
template <class Accepted>
TreeHit cast(const ray_t& ray, const job_t& job, const Loaded& loaded, const Windows& windows, const Started& started,
             WorkCounters& counters, Accepted&& accepted) {
  const auto on_accepted = [&](const cand_t& cand, const result_t* result) {
    ++counters.candidates;
    accepted(cand, result);
  };
  TreeHit found;
  if (job.brute) {
    found.hit = lane(ray, loaded.slots, counters.tests, on_accepted);
  } else {
    const Tree tree{.image = windows.image.data(), .header = &loaded.header, .limit = job.steps, .tile = started.nodes};
    found = lane(ray, tree, start_of(started.start, tree.root().first), on_accepted);
    counters.tests += found.work.tests;
    counters.nodes += found.work.nodes;
  }
  ++counters.rays;
  counters.hits += found.hit.found;
  return found;
}

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
void write_pixel(const hit_t& hit, const job_t& job, const Loaded& loaded, const Windows& windows) {
  const std::uint32_t colour = static_cast<std::uint32_t>(colour_of(hit, loaded, windows).colour);
  std::memcpy(&windows.frame[hit.tag.y * loaded.record.stride + hit.tag.x * PixelBytes], &colour, PixelBytes);
  if (job.want_hits) store_record(&windows.hits[hit_offset(hit.tag, job.width)], hit_record(hit));
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
error_t render_tile(const tile_t& tile, const job_t& job, const Loaded& loaded, const Windows& windows, WorkCounters& counters) {
  const TileStart start = start_tile(tile, job, loaded, windows);
  counters.tile_nodes += static_cast<std::uint64_t>(start.read);
  error_t error = start.error;
  const bool empty = start.start == static_cast<std::uint64_t>(TileEmpty);
  if (empty && error == ErrNone && !job.want_hits) ++counters.empty_tiles;
  for_each_pixel(tile, [&](const pixel_tag_t& tag) {
    if (error != ErrNone) return;
    TreeHit found;
    found.hit.tag = tag;
    if (!empty) {
      const ray_t ray = ray_setup(ray_gen(loaded.camera, static_cast<int>(tag.x), static_cast<int>(tag.y)), loaded.camera, tag);
      found = cast(slab_setup(ray), job, loaded, windows, {start.start, std::span(start.nodes.node).first(start.nodes.count)},
                   counters, [](const cand_t&, const result_t*) {});
    }
    error = found.error;
    if (error == ErrNone) write_pixel(found.hit, job, loaded, windows);
  });
  return error;
}

}  // namespace

WorkCounters& WorkCounters::operator+=(const WorkCounters& other) {
  tests += other.tests;
  rays += other.rays;
  hits += other.hits;
  candidates += other.candidates;
  nodes += other.nodes;
  tile_nodes += other.tile_nodes;
  empty_tiles += other.empty_tiles;
  return *this;
}

Outcome run_job(const job_t& job, const Windows& windows, const RunOptions& options) {
  const Loaded loaded = load(job, windows);
  Outcome outcome;
  outcome.error = loaded.error;
  if (loaded.error != ErrNone) return outcome;

  std::vector<tile_t> tiles;
  for_each_tile(job, options.tile_log2, 1, [&](const tile_t& tile) { tiles.push_back(tile); });
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0;
  const auto work = [&] {
    WorkCounters counters;
    for (std::size_t i = next++; i < tiles.size(); i = next++) {
      const error_t error = render_tile(tiles[i], job, loaded, windows, counters);
      const std::scoped_lock lock(mutex);
      if (error != ErrNone && outcome.error == ErrNone) {
        outcome.error = error;
        next = tiles.size();
      }
      ++done;
      if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(tiles.size()));
    }
    const std::scoped_lock lock(mutex);
    outcome.counters += counters;
  };
  const unsigned count = options.threads > 0 ? static_cast<unsigned>(options.threads) : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> pool;
  for (unsigned i = 1; i < count; ++i) pool.emplace_back(work);
  work();
  pool.clear();
  return outcome;
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
