// SPDX-License-Identifier: Apache-2.0
// The core's counters by the names that reports give them.
#pragma once
#include <array>
#include <utility>

#include "castray_records.hpp"

namespace castray::sim {

inline constexpr std::array<std::pair<std::int64_t, const char*>, Counters> kCounterNames{{
    {CntCycles, "cycles"},           {CntTests, "tests"},
    {CntRays, "rays"},               {CntHits, "hits"},
    {CntCandidates, "candidates"},   {CntBatches, "batches"},
    {CntTestStalls, "test_stalls"},  {CntFetchStalls, "fetch_stalls"},
    {CntAttrHits, "attr_hits"},      {CntAttrMisses, "attr_misses"},
    {CntReadBeats, "read_beats"},    {CntWriteBeats, "write_beats"},
    {CntNodes, "nodes"},             {CntNodeHits, "node_hits"},
    {CntNodeMisses, "node_misses"},  {CntLeafHits, "leaf_hits"},
    {CntLeafMisses, "leaf_misses"},  {CntNodeWaits, "node_waits"},
    {CntLeafWaits, "leaf_waits"},    {CntTestWaits, "test_waits"},
    {CntL2Hits, "l2_hits"},          {CntL2Misses, "l2_misses"},
    {CntTileNodes, "tile_nodes"},    {CntTileHits, "tile_hits"},
    {CntTileMisses, "tile_misses"},  {CntEmptyTiles, "empty_tiles"},
    {CntHitUnitBusy, "hit_unit_busy"}, {CntShaderBusy, "shader_busy"},
    {CntTileBusy, "tile_busy"},      {CntStarved, "starved"},
    {CntHitWaits, "hit_waits"},      {CntWriteWaits, "write_waits"},
}};

}  // namespace castray::sim
