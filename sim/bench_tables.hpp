// SPDX-License-Identifier: Apache-2.0
// The records of a bench as the page docs/bench.md: castray's figures beside the report's tables.
#pragma once
#include <string>
#include <vector>

#include "bench_runs.hpp"

namespace castray::bench {

std::string page_of(const std::vector<Json>& records);

// What must hold and does not, one line each.
std::vector<std::string> broken_bars(const std::vector<Json>& records);

}  // namespace castray::bench
