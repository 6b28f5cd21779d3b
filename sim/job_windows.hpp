// SPDX-License-Identifier: Apache-2.0
// The memory that a job may touch, and how much of it the core writes.
#pragma once
#include <cstdint>
#include <vector>

#include "castray_records.hpp"

namespace castray::sim {

struct JobWindow {
  const char* name;
  std::uint64_t address = 0;
  std::uint64_t bytes = 0;
  bool written = false;  // by the core; else read
};

inline std::vector<JobWindow> windows_of(const job_t& job) {
  std::vector<JobWindow> windows{{"scene image", job.image, job.image_bytes, false}};
  if (job.is_list) windows.push_back({"list of rays", job.rays, job.ray_bytes, false});
  else windows.push_back({"frame buffer", job.frame, job.frame_bytes, true});
  if (job.want_hits) windows.push_back({"hit buffer", job.hits, job.hits_bytes, true});
  return windows;
}

inline std::uint64_t bytes_written(const job_t& job) {
  if (job.is_list) return job.ray_count * HitBytes;
  return (job.x1 - job.x0) * (job.y1 - job.y0) * (PixelBytes + (job.want_hits ? HitBytes : 0));
}

}  // namespace castray::sim
