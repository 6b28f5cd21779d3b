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
#include "work_counters.hpp"

namespace castray {

// The windows of memory that a job may touch.
struct Windows {
  std::span<const std::uint8_t> image;
  std::span<std::uint8_t> frame;
  std::span<std::uint8_t> hits;
  std::span<const std::uint8_t> rays = {};
};

// The errors of a job, or of a part of it: that of the first ray or tile that has one, and a bit for the code of each.
struct Errors {
  error_t first = ErrNone;
  std::uint32_t all = 0;

  Errors() = default;
  Errors(error_t error) : first(error), all(error == ErrNone ? 0 : std::uint32_t{1} << error) {}
  Errors& operator+=(const Errors& behind) {
    if (first == ErrNone) first = behind.first;
    all |= behind.all;
    return *this;
  }
};

struct Outcome {
  error_t error = ErrNone;    // the first part's that has one
  std::uint32_t errors = 0;   // a bit for each: complete if every error was asked for
  WorkCounters counters;
};


// Called now and then with the share of pixels or rays done, 0 to 1.
using Progress = std::function<void(double)>;

struct RunOptions {
  int tile_log2 = DefaultTileLog2;  // the work depends on it, the outcome does not
  int threads = 0;                  // 0: all of the machine
  Progress progress;
  bool every_error = false;         // goes on behind an error: which of them a core meets first is a matter of time
};

// Runs a job. On an error nothing more is written, unless every one is asked for.
Outcome run_job(const job_t& job, const Windows& windows, const RunOptions& options = {});

}  // namespace castray
