// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "counter_names.hpp"
#include "work_counters.hpp"

namespace castray::sim {
namespace {
constexpr std::size_t kFirst = 8;

bool record_differs(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, std::size_t i) {
  return std::memcmp(&a[i * HitBytes], &b[i * HitBytes], HitBytes) != 0;
}
}

Comparison compare(const Rendering& a, const Rendering& b) {
  Comparison result;
  if (a.width != b.width || a.height != b.height) {
    result.pixels_differ = result.hits_differ = std::max(a.pixels.size(), b.pixels.size());
    return result;
  }
  const bool hits = !a.hits.empty() && !b.hits.empty();
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const bool pixel = a.pixels[i] != b.pixels[i];
    const bool hit = hits && record_differs(a.hits, b.hits, i);
    result.pixels_differ += pixel;
    result.hits_differ += hit;
    if ((pixel || hit) && result.first.size() < kFirst) result.first.push_back(i);
  }
  return result;
}

Comparison compare(const Answers& a, const Answers& b) {
  Comparison result;
  if (a.size() != b.size()) {
    result.hits_differ = std::max(a.size(), b.size());
    return result;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!record_differs(a.hits, b.hits, i)) continue;
    if (result.hits_differ++ < kFirst) result.first.push_back(i);
  }
  return result;
}

std::vector<std::string> counters_that_differ(const Counts& core, const Counts& model) {
  std::vector<std::string> lines;
  for (const auto& work : kWorkCounters) {
    const auto i = static_cast<std::size_t>(work.first);
    const auto named = std::ranges::find(kCounterNames, work.first, [](const auto& name) { return name.first; });
    if (core[i] != model[i])
      lines.push_back(std::string("counter ") + named->second + ": " + std::to_string(core[i]) + ", in the model " + std::to_string(model[i]));
  }
  return lines;
}

std::string text_of(const Rendering& rendering, std::size_t pixel) {
  char word[16];
  std::snprintf(word, sizeof word, "0x%08x", rendering.pixels[pixel]);
  std::string text = std::string("pixel ") + word;
  if (!rendering.hits.empty()) text += ", hit " + to_text(rendering.hit(pixel));
  return text;
}

}  // namespace castray::sim
