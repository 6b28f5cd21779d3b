// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

namespace castray::cli {

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

void print_work(const Counts& counters, double seconds, std::FILE* out) {
  const auto count = [&](std::int64_t index) { return grouped(counters[static_cast<std::size_t>(index)]); };
  std::fprintf(out, "  rays %s, hits %s; tests of nodes %s, of primitives %s, of which the exact test accepted %s\n", count(CntRays).c_str(),
               count(CntHits).c_str(), count(CntNodes).c_str(), count(CntTests).c_str(), count(CntCandidates).c_str());
  std::fprintf(out, "  %.2f s\n", seconds);
}

void print_counters(const Counts& counters, std::FILE* out, const char* with) {
  const auto count = [&](std::int64_t index) { return grouped(counters[static_cast<std::size_t>(index)]); };
  const auto share = [&](std::int64_t hits, std::int64_t misses) {
    const auto of = [&](std::int64_t index) { return static_cast<double>(counters[static_cast<std::size_t>(index)]); };
    return of(hits) + of(misses) > 0 ? 100 * of(hits) / (of(hits) + of(misses)) : 0.0;
  };
  std::fprintf(out, "  cycles %s%s\n", count(CntCycles).c_str(), with);
  // A list of rays has neither tiles nor attributes.
  const auto if_any = [&](std::int64_t one, std::int64_t other, const std::string& text) {
    return counters[static_cast<std::size_t>(one)] + counters[static_cast<std::size_t>(other)] > 0 ? text : "";
  };
  const std::string tiles = if_any(CntTileNodes, CntEmptyTiles, "; tiles: " + count(CntTileNodes) + " nodes read to start them, " + count(CntEmptyTiles) + " filled");
  const std::string attributes = if_any(CntAttrHits, CntAttrMisses, "; attributes: " + count(CntAttrHits) + " in the cache, " + count(CntAttrMisses) + " fetched");
  if (counters[CntBatches] > 0) {
    std::fprintf(out, "  brute force: %s passes, %s cycles waiting for a lane, %s for a primitive\n", count(CntBatches).c_str(),
                 count(CntTestStalls).c_str(), count(CntFetchStalls).c_str());
  } else {
    std::fprintf(out, "  caches hit: nodes %.1f%%, leaves %.1f%%, shared %.1f%%%s\n", share(CntNodeHits, CntNodeMisses),
                 share(CntLeafHits, CntLeafMisses), share(CntL2Hits, CntL2Misses), tiles.c_str());
    std::fprintf(out, "  cycles of lanes in which a ray waited to look up a node %s, a leaf %s, a test for its queue %s\n", count(CntNodeWaits).c_str(),
                 count(CntLeafWaits).c_str(), count(CntTestWaits).c_str());
  }
  std::fprintf(out, "  read beats %s, write beats %s%s\n", count(CntReadBeats).c_str(), count(CntWriteBeats).c_str(), attributes.c_str());
}

void print_run(const sim::RtlFacts& run, const Counts& counters, std::FILE* out, const char* with) {
  print_counters(counters, out, with);
  std::fprintf(out, "  simulated %.3f M cycles a second\n", run.per_second(counters[CntCycles]) / 1e6);
  bool stalled = false;
  for (const sim::StallShare& share : run.shares) stalled |= share.blocked > 0;
  if (stalled) {
    std::fprintf(out, "  blocked:");
    for (unsigned i = 0; i < sim::kChannels; ++i)
      std::fprintf(out, " %s %.0f%% of %s", sim::kChannelNames[i], 100 * run.shares[i].share(), grouped(run.shares[i].wanted).c_str());
    std::fprintf(out, " cycles in which it was wanted\n");
  }
  print_violations(run, out);
}

void print_violations(const sim::RtlFacts& run, std::FILE* out) {
  if (run.violations == 0) return;
  std::fprintf(out, "  the core broke rules of its bus %s times:\n", grouped(run.violations).c_str());
  for (const std::string& message : run.messages) std::fprintf(out, "    %s\n", message.c_str());
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
