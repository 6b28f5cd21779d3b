// SPDX-License-Identifier: Apache-2.0
// The parts of a job on several threads.
#pragma once
#include "core.hpp"
#include "parallel.hpp"

namespace castray {

// work(part, counters) for each part below `parts`, until one gives an error: the job's. Parts begin in their order, so
// that the first part with an error is always the same.
template <class Work> Outcome in_parallel(std::size_t parts, const RunOptions& options, Work&& work) {
  struct Part {
    Errors errors;
    WorkCounters counters;
  };
  Outcome job;
  std::size_t failed = parts;
  parallel(parts, options.threads,
           [&](std::size_t i) {
             Part part;
             part.errors = work(i, part.counters);
             return part;
           },
           [&](std::size_t i, const Part& part, std::size_t done) {
             job.counters += part.counters;
             job.errors |= part.errors.all;
             if (part.errors.first != ErrNone && i < failed) {
               job.error = part.errors.first;
               failed = i;
             }
             if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(parts));
             return failed == parts || options.every_error;
           });
  return job;
}

}  // namespace castray
