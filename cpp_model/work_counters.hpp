// SPDX-License-Identifier: Apache-2.0
// The counters that do not depend on time: equal in the core and in its model.
#pragma once
#include <array>
#include <cstdint>
#include <utility>

#include "castray_records.hpp"

namespace castray {

struct WorkCounters {
  std::uint64_t tests = 0;
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  std::uint64_t candidates = 0;
  std::uint64_t nodes = 0;
  std::uint64_t tile_nodes = 0;   // read to start tiles
  std::uint64_t empty_tiles = 0;  // filled with background
  WorkCounters& operator+=(const WorkCounters& other);
  bool operator==(const WorkCounters&) const = default;
};

// Their places among a job's counters.
inline constexpr std::array<std::pair<std::int64_t, std::uint64_t WorkCounters::*>, 7> kWorkCounters{{
    {CntTests, &WorkCounters::tests},
    {CntRays, &WorkCounters::rays},
    {CntHits, &WorkCounters::hits},
    {CntCandidates, &WorkCounters::candidates},
    {CntNodes, &WorkCounters::nodes},
    {CntTileNodes, &WorkCounters::tile_nodes},
    {CntEmptyTiles, &WorkCounters::empty_tiles},
}};
static_assert(sizeof(WorkCounters) == kWorkCounters.size() * sizeof(std::uint64_t));

inline WorkCounters& WorkCounters::operator+=(const WorkCounters& other) {
  for (const auto& [index, count] : kWorkCounters) this->*count += other.*count;
  return *this;
}

}  // namespace castray
