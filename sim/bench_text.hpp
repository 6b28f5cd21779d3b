// SPDX-License-Identifier: Apache-2.0
// What the tables of the bench share: records picked out, numbers as text.
#pragma once
#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench_runs.hpp"

namespace castray::bench {

// The report ("Ray Tracing Acceleration on FPGA"): cycles of its frame and of its bound.
constexpr double kReportCycles = 166.5e6;
constexpr double kReportBound = 161.8e6;

[[gnu::format(printf, 1, 2)]] inline std::string format(const char* pattern, ...) {
  char text[400];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

using Keep = std::function<bool(const Json&)>;
inline std::vector<Json> only(const std::vector<Json>& records, const std::string& part, const Keep& keep = {}) {
  std::vector<Json> kept;
  for (const Json& r : records)
    if (r["part"] == part && (!keep || keep(r))) kept.push_back(r);
  return kept;
}

inline const Json* find(const std::vector<Json>& records, const Keep& keep) {
  const auto at = std::ranges::find_if(records, keep);
  return at == records.end() ? nullptr : &*at;
}
inline std::string percent(const Json& share) { return share.is_null() ? "-" : format("%.1f%%", 100 * share.get<double>()); }

inline double mega(const Json& r) { return r["cycles"].get<double>() / 1e6; }
inline std::string text(const Json& r, const char* key) { return r[key].get<std::string>(); }
inline std::string size_of(const Json& r) { return format("%dx%d", r["width"].get<int>(), r["height"].get<int>()); }
inline std::string differ(const Json& r) {
  return format("%lu / %lu", r["pixels_differ"].get<unsigned long>(), r["hits_differ"].get<unsigned long>());
}
// The shares of the wanted cycles in which a channel was blocked, a cell each.
constexpr const char* kChannels[] = {"ar", "r", "aw", "w", "b"};
inline std::string blocked(const Json& r) {
  std::string cells;
  for (const char* channel : kChannels) cells += format(" %.0f%% |", 100 * r["blocked"].value(channel, 0.0));
  return cells;
}

}  // namespace castray::bench
