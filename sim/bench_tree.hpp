// SPDX-License-Identifier: Apache-2.0
// The bench's sections of the hierarchy, and the cycles that its frames may take.
#pragma once
#include <string>
#include <vector>

#include "bench_runs.hpp"

namespace castray::bench {

std::string tree(const std::vector<Json>& records);
std::string tree_tiles(const std::vector<Json>& records);
std::string tree_stalls(const std::vector<Json>& records);
std::string lists(const std::vector<Json>& records);

// What a frame may take, or 0 where there is no bar.
std::uint64_t bar_of(const Json& record);

}  // namespace castray::bench
