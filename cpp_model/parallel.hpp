// SPDX-License-Identifier: Apache-2.0
// The parts of some work on several threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace castray {

// work(part) for each part below `parts`, begun in their order, on so many threads, 0: as the machine has. finished(part,
// what it gave, how many are finished) is called by one thread at a time; once it is false no other part is begun.
template <class Work, class Finished> void parallel(std::size_t parts, int threads, Work&& work, Finished&& finished) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0;
  const auto worker = [&] {
    for (std::size_t i = next++; i < parts; i = next++) {
      const auto result = work(i);
      const std::scoped_lock lock(mutex);
      if (!finished(i, result, ++done)) next = parts;
    }
  };
  const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads) : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> pool;
  for (std::size_t i = 1; i < std::min(wanted, parts); ++i) pool.emplace_back(worker);
  worker();
}

}  // namespace castray
