// SPDX-License-Identifier: Apache-2.0
// The whole core as a plain program: mirrors rtl/castray_core.sv. A job reads the bytes of the
// scene image, of a list of rays too, and writes the bytes of the frame and hit buffers, equal to the
// RTL's bit for bit.
// No outcome depends on lanes, contexts, order or time, so none of them exists here.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "fixed.hpp"

namespace castray {

// The windows of memory that a job may touch.
struct Windows {
  std::span<const std::uint8_t> image;
  std::span<std::uint8_t> frame;
  std::span<std::uint8_t> hits;
  std::span<const std::uint8_t> rays = {};
};

// The counters that do not depend on time.
struct WorkCounters {
  std::uint64_t tests = 0;
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  std::uint64_t candidates = 0;
  std::uint64_t nodes = 0;
  std::uint64_t tile_nodes = 0;   // read to start tiles
  std::uint64_t empty_tiles = 0;  // filled with background
  WorkCounters& operator+=(const WorkCounters& other);
  bool operator==(const WorkCounters&) const = default;
};

struct Outcome {
  error_t error = ErrNone;
  WorkCounters counters;
};

// What happened to one ray, stage by stage.
struct RayTrace {
  pixel_tag_t tag;
  dir_t dir;
  ray_t ray;
  std::vector<cand_t> candidates;
  std::vector<result_t> results;
  hit_t hit;
  shaded_t shaded;
  hit_record_t record;
};

// Called now and then with the share of pixels or rays done, 0 to 1.
using Progress = std::function<void(double)>;

struct RunOptions {
  int tile_log2 = DefaultTileLog2;  // the work depends on it, the outcome does not
  int threads = 0;                  // 0: all of the machine
  Progress progress;
};

// Runs a job. On an error nothing more is written.
Outcome run_job(const job_t& job, const Windows& windows, const RunOptions& options = {});

// The stages of the ray through pixel (x, y). Throws std::runtime_error with the error code's
// number if the job is refused.
RayTrace trace_pixel(const job_t& job, const Windows& windows, int x, int y);

}  // namespace castray
