// SPDX-License-Identifier: Apache-2.0
// The parts of a job on several threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "core.hpp"

namespace castray {

// work(part, counters) for each part below `parts`, until one gives an error: the job's. Parts begin in their order, so
// that the first part with an error is always the same.
template <class Work> Outcome in_parallel(std::size_t parts, const RunOptions& options, Work&& work) {
  Outcome outcome;
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0, failed = parts;
  const auto worker = [&] {
    WorkCounters counters;
    for (std::size_t i = next++; i < parts; i = next++) {
      const Errors errors = work(i, counters);
      const std::scoped_lock lock(mutex);
      outcome.errors |= errors.all;
      if (errors.first != ErrNone && i < failed) {
        outcome.error = errors.first;
        failed = i;
      }
      if (failed < parts && !options.every_error) next = parts;
      ++done;
      if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(parts));
    }
    const std::scoped_lock lock(mutex);
    outcome.counters += counters;
  };
  const unsigned count = options.threads > 0 ? static_cast<unsigned>(options.threads) : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> pool;
  for (unsigned i = 1; i < count; ++i) pool.emplace_back(worker);
  worker();
  pool.clear();
  return outcome;
}

}  // namespace castray
