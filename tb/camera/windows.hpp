// SPDX-License-Identifier: Apache-2.0
// Jobs on a window of a frame.
#pragma once
#include "fixed.hpp"

namespace castray::tb {

inline job_t window(std::uint64_t width, std::uint64_t height, std::uint64_t x0, std::uint64_t y0, std::uint64_t x1, std::uint64_t y1, bool z_order) {
  job_t job;
  job.width = width;
  job.height = height;
  job.x0 = x0;
  job.y0 = y0;
  job.x1 = x1;
  job.y1 = y1;
  job.z_order = z_order;
  return job;
}

}  // namespace castray::tb
