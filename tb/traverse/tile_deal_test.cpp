// SPDX-License-Identifier: Apache-2.0
// Which lane a tile goes to: one with room for it, in turn; and what becomes of empty tiles.
// Verilator: -GLanes=3 -GTileLog2=3
#include <algorithm>
#include <array>
#include <deque>

#include "Vtile_deal.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kLanes = 3, kPixels = 64, kLow = 16;   // kLow: as in tile_deal.sv

class TileDeal : public testing::TestWithParam<Stalls> {
 protected:
  TileDeal() {
    dut->direct_i = dut->each_miss_i = dut->left_i = 0;
    dut->pixels_ready_i = dut->fill_ready_i = 1;
  }
  static started_t tile(std::uint64_t start, std::uint64_t width = 8, std::uint64_t height = 8) {
    started_t started;
    started.start = start;
    started.tile.width = width, started.tile.height = height;
    return started;
  }
  void offer(const started_t& started) {
    set_port(dut->in_i, started);
    dut->in_valid_i = 1;
    dut.settle();
  }
  // The tile is taken; what becomes of it is seen at the outputs then.
  void give(const started_t& started) {
    offer(started);
    EXPECT_TRUE(dut->in_ready_o);
    dut.tick();
    dut->in_valid_i = 0;
    dut.settle();
  }
  Dut<Vtile_deal> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, TileDeal, testing::ValuesIn(kStallPatterns));

// Tiles that are not empty leave in order, each to a lane that has run low, and none waits while there is one.
TEST_P(TileDeal, DealsToALaneThatHasRunLow) {
  const Stalls stalls = GetParam();
  Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2), lanes(0.6, 4, 3);
  std::mt19937 rng(4);
  std::array<long, kLanes> held{}, tiles{};
  std::deque<started_t> waiting;
  bool offering = false;
  started_t next;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    if (!offering && source.open()) {
      offering = true;
      next = tile(rng() % 4, 1 + rng() % 8, 1 + rng() % 8);
      next.tile.x = static_cast<std::uint64_t>(cycle) % 4096;
    }
    dut->pixels_ready_i = sink.open();
    dut->fill_ready_i = sink.open();
    unsigned left = 0;
    for (int i = 0; i < kLanes; ++i)
      if (held[static_cast<std::size_t>(i)] > 0 && lanes.open()) left |= 1u << i;
    dut->left_i = left;
    set_port(dut->in_i, next);
    dut->in_valid_i = offering;
    dut.settle();
    const bool empty = next.start == TileEmpty;
    EXPECT_EQ(dut->idle_o, waiting.empty());
    EXPECT_EQ(dut->fill_valid_o, offering && empty);
    if (offering) EXPECT_EQ(dut->in_ready_o, empty ? dut->fill_ready_i : waiting.size() < DealTiles);
    const bool low = *std::min_element(held.begin(), held.end()) <= kLow;
    EXPECT_EQ(dut->pixels_valid_o, low && !waiting.empty());
    EXPECT_EQ(dut->deal_valid_o, dut->pixels_valid_o && dut->pixels_ready_i);
    if (dut->deal_valid_o) {
      const std::size_t lane = dut->deal_lane_o;
      ASSERT_LT(lane, held.size());
      EXPECT_LE(held[lane], kLow) << "lane " << lane << " has not run low";
      EXPECT_TRUE(get_port<started_t>(dut->out_o) == waiting.front());
      EXPECT_FALSE(dut->miss_o);
      held[lane] += static_cast<long>(waiting.front().tile.width * waiting.front().tile.height);
      ++tiles[lane];
      waiting.pop_front();
    }
    for (int i = 0; i < kLanes; ++i) held[static_cast<std::size_t>(i)] -= left >> i & 1;
    if (offering && dut->in_ready_o) {
      if (!empty) waiting.push_back(next);
      offering = false;
    }
    dut.tick();
    ASSERT_FALSE(HasFailure()) << "cycle " << cycle;
  }
  for (const long count : tiles) EXPECT_GT(count, 100);
}

TEST_F(TileDeal, IdleLanesTakeTheirTurns) {
  for (int i = 0; i < kLanes; ++i) {
    give(tile(TileRoot));
    EXPECT_TRUE(dut->deal_valid_o);
    EXPECT_EQ(dut->deal_lane_o, i);
    dut.tick();
  }
  give(tile(TileTwo, 1, 1));
  EXPECT_FALSE(dut->pixels_valid_o) << "all lanes have enough";
  dut->left_i = 0b010;
  for (int i = 0; i < kPixels - kLow; ++i) {
    EXPECT_FALSE(dut->pixels_valid_o);
    dut.tick();
  }
  dut->left_i = 0;
  dut.settle();
  EXPECT_TRUE(dut->deal_valid_o);
  EXPECT_EQ(dut->deal_lane_o, 1);
}

TEST_F(TileDeal, EmptyTilesPassThoseThatWait) {
  for (int i = 0; i < kLanes + 2; ++i) give(tile(TileRoot)), dut.tick();
  EXPECT_FALSE(dut->pixels_valid_o);
  started_t empty = tile(TileEmpty);
  empty.tile.slot = 13;
  offer(empty);
  EXPECT_TRUE(dut->fill_valid_o && dut->in_ready_o);
  EXPECT_EQ(dut->fill_slot_o, 13);
}

TEST_F(TileDeal, EmptyTilesGivePixelsWhereEachMissIsWanted) {
  dut->each_miss_i = 1;
  offer(tile(TileEmpty));
  EXPECT_FALSE(dut->fill_valid_o);
  give(tile(TileEmpty));
  EXPECT_TRUE(dut->pixels_valid_o && dut->miss_o);
  EXPECT_FALSE(dut->fill_valid_o || dut->deal_valid_o);
}

TEST_F(TileDeal, DirectTilesGoToNoLane) {
  dut->direct_i = 1;
  for (int i = 0; i < 10; ++i) {
    give(tile(i % 2 ? TileRoot : TileEmpty));
    EXPECT_TRUE(dut->pixels_valid_o && !dut->miss_o);
    EXPECT_FALSE(dut->fill_valid_o || dut->deal_valid_o);
    dut.tick();
  }
}

}  // namespace
}  // namespace castray::tb
