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
#include "mem/hit_writer.hpp"
#include "mem/image.hpp"
#include "mem/prim_reader.hpp"
#include "shade/paint.hpp"
#include "shade/shade.hpp"
#include "traverse/lane.hpp"

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
  loaded.slots = read_slots(windows.image.data(), loaded.header);
  for (const prim_slot_t& slot : loaded.slots)
    if (!slot_ok(slot, loaded.header)) loaded.error = ErrPrimitive;
  return loaded;
}

// A lane's work for one ray, and what it adds to the counters.
template <class Accepted>
hit_t cast(const ray_t& ray, const std::vector<prim_slot_t>& slots, WorkCounters& counters, Accepted&& accepted) {
  const hit_t hit = lane(ray, slots, counters.tests, [&](const cand_t& cand, const result_t* result) {
    ++counters.candidates;
    accepted(cand, result);
  });
  ++counters.rays;
  counters.hits += hit.found;
  return hit;
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

// One row of the window into the frame and hit buffers.
void render_row(int y, const job_t& job, const Loaded& loaded, const Windows& windows, WorkCounters& counters) {
  for (int x = static_cast<int>(job.x0); x < static_cast<int>(job.x1); ++x) {
    const ray_t ray = ray_setup(ray_gen(loaded.camera, x, y), loaded.camera, tag_of(x, y));
    const hit_t hit = cast(ray, loaded.slots, counters, [](const cand_t&, const result_t*) {});
    const std::uint32_t colour = static_cast<std::uint32_t>(colour_of(hit, loaded, windows).colour);
    std::memcpy(&windows.frame[static_cast<std::size_t>(y) * loaded.record.stride + static_cast<std::size_t>(x) * PixelBytes],
                &colour, PixelBytes);
    if (job.want_hits) store_record(&windows.hits[hit_offset(hit.tag, job.width)], hit_record(hit));
  }
}

}  // namespace

Outcome run_job(const job_t& job, const Windows& windows, const Progress& progress, int threads) {
  const Loaded loaded = load(job, windows);
  Outcome outcome;
  outcome.error = loaded.error;
  if (loaded.error != ErrNone) return outcome;

  const int first = static_cast<int>(job.y0), end = static_cast<int>(job.y1);
  std::atomic<int> next = first;
  std::mutex mutex;
  int done = 0;
  const auto work = [&] {
    WorkCounters counters;
    for (int y = next++; y < end; y = next++) {
      render_row(y, job, loaded, windows, counters);
      const std::scoped_lock lock(mutex);
      ++done;
      if (progress) progress(static_cast<double>(done) / (end - first));
    }
    const std::scoped_lock lock(mutex);
    outcome.counters.tests += counters.tests;
    outcome.counters.rays += counters.rays;
    outcome.counters.hits += counters.hits;
    outcome.counters.candidates += counters.candidates;
  };
  const unsigned count = threads > 0 ? static_cast<unsigned>(threads) : std::max(1u, std::thread::hardware_concurrency());
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
  trace.ray = ray_setup(trace.dir, loaded.camera, trace.tag);
  trace.hit = cast(trace.ray, loaded.slots, counters, [&](const cand_t& cand, const result_t* result) {
    trace.candidates.push_back(cand);
    if (result) trace.results.push_back(*result);
  });
  trace.shaded = colour_of(trace.hit, loaded, windows);
  trace.record = hit_record(trace.hit);
  return trace;
}

}  // namespace castray
