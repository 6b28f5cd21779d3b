// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <cstdio>

namespace castray::cli {

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

void print_work(const sim::Rendering& rendering, double seconds) {
  const auto count = [&](std::int64_t index) { return grouped(rendering.counters[static_cast<std::size_t>(index)]); };
  std::printf("  rays %s, hits %s; tests of nodes %s, of primitives %s, of which the exact test accepted %s\n", count(CntRays).c_str(),
              count(CntHits).c_str(), count(CntNodes).c_str(), count(CntTests).c_str(), count(CntCandidates).c_str());
  std::printf("  %.2f s\n", seconds);
}

void print_run(const sim::RtlRun& run) {
  const auto count = [&](std::int64_t index) { return grouped(run.rendering.counters[static_cast<std::size_t>(index)]); };
  const auto share = [&](std::int64_t hits, std::int64_t misses) {
    const auto of = [&](std::int64_t index) { return static_cast<double>(run.rendering.counters[static_cast<std::size_t>(index)]); };
    return of(hits) + of(misses) > 0 ? 100 * of(hits) / (of(hits) + of(misses)) : 0.0;
  };
  std::printf("  cycles %s\n", count(CntCycles).c_str());
  if (run.rendering.counters[CntBatches] > 0)
    std::printf("  brute force: %s passes, %s cycles waiting for a lane, %s for a primitive\n", count(CntBatches).c_str(),
                count(CntTestStalls).c_str(), count(CntFetchStalls).c_str());
  else
    std::printf("  caches hit: nodes %.1f%%, leaves %.1f%%, shared %.1f%%; tiles: %s nodes read to start them, %s filled\n",
                share(CntNodeHits, CntNodeMisses), share(CntLeafHits, CntLeafMisses), share(CntL2Hits, CntL2Misses),
                count(CntTileNodes).c_str(), count(CntEmptyTiles).c_str());
  std::printf("  read beats %s, write beats %s; attributes: %s in the cache, %s fetched\n", count(CntReadBeats).c_str(),
              count(CntWriteBeats).c_str(), count(CntAttrHits).c_str(), count(CntAttrMisses).c_str());
  std::printf("  simulated %.3f M cycles a second\n", run.cycles_per_second() / 1e6);
  bool stalled = false;
  for (const sim::StallShare& share : run.shares) stalled |= share.blocked > 0;
  if (stalled) {
    std::printf("  blocked:");
    for (unsigned i = 0; i < sim::kChannels; ++i)
      std::printf(" %s %.0f%% of %s", sim::kChannelNames[i], 100 * run.shares[i].share(), grouped(run.shares[i].wanted).c_str());
    std::printf(" cycles in which it was wanted\n");
  }
  print_violations(run);
}

void print_violations(const sim::RtlRun& run) {
  if (run.violations == 0) return;
  std::printf("  the core broke rules of its bus %s times:\n", grouped(run.violations).c_str());
  for (const std::string& message : run.messages) std::printf("    %s\n", message.c_str());
}

void print_comparison(const sim::Comparison& comparison, const sim::Rendering& rendering) {
  const std::string all = grouped(rendering.pixels.size());
  std::printf("  against the model: %s of %s pixels and %s of %s hit records differ\n", grouped(comparison.pixels_differ).c_str(),
              all.c_str(), grouped(comparison.hits_differ).c_str(), all.c_str());
}

void print_reference(const sim::ReferenceCheck& check) {
  std::printf("  against float64: of %s pixels %zu see another primitive, %zu another cell of the checker; of the others %zu are\n"
              "  more than 1 of 255 away in a channel (worst %d)\n",
              grouped(check.pixels).c_str(), check.other_primitive, check.other_cell, check.far_colour, check.worst);
}

}  // namespace castray::cli
