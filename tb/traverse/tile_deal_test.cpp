// SPDX-License-Identifier: Apache-2.0
// Which lane a tile goes to: one with room for it, in turn; and what becomes of empty tiles.
// Verilator: -GLanes=3 -GTileLog2=3
#include <array>

#include "Vtile_deal.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kLanes = 3, kQueue = 64, kPixels = 64;

class TileDeal : public testing::TestWithParam<Stalls> {
 protected:
  TileDeal() {
    dut->direct_i = dut->each_miss_i = dut->left_i = 0;
    dut->pixels_ready_i = dut->fill_ready_i = 1;
  }
  void offer(std::int64_t start, std::uint64_t width = 8, std::uint64_t height = 8) {
    started_t tile;
    tile.start = static_cast<std::uint64_t>(start);
    tile.tile.width = width, tile.tile.height = height;
    set_port(dut->in_i, tile);
    dut->in_valid_i = 1;
    dut.settle();
  }
  Dut<Vtile_deal> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, TileDeal, testing::ValuesIn(kStallPatterns));

// The rays of all tiles never fill a lane's queue, and no tile waits while some lane has room.
TEST_P(TileDeal, DealsToALaneWithRoom) {
  const Stalls stalls = GetParam();
  Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2), lanes(0.6, 4, 3);
  std::mt19937 rng(4);
  std::array<long, kLanes> held{}, tiles{};
  bool offering = false;
  std::uint64_t width = 0, height = 0;
  std::int64_t start = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    if (!offering && source.open()) {
      offering = true;
      width = 1 + rng() % 8, height = 1 + rng() % 8, start = rng() % 4;
    }
    dut->pixels_ready_i = sink.open();
    unsigned left = 0;
    for (int i = 0; i < kLanes; ++i)
      if (held[static_cast<std::size_t>(i)] > 0 && lanes.open()) left |= 1u << i;
    dut->left_i = left;
    offer(start, width, height);
    dut->in_valid_i = offering;
    dut.settle();
    const bool room = *std::min_element(held.begin(), held.end()) <= kQueue - kPixels;
    if (!offering) {
      EXPECT_FALSE(dut->deal_valid_o || dut->pixels_valid_o || dut->fill_valid_o);
    } else if (start == TileEmpty) {
      EXPECT_TRUE(dut->fill_valid_o && dut->in_ready_o && !dut->pixels_valid_o && !dut->deal_valid_o);
    } else {
      EXPECT_EQ(dut->pixels_valid_o, room);
      EXPECT_EQ(dut->in_ready_o, room && dut->pixels_ready_i);
      EXPECT_EQ(dut->deal_valid_o, dut->in_ready_o);
      EXPECT_FALSE(dut->miss_o);
      if (dut->deal_valid_o) {
        const std::size_t lane = dut->deal_lane_o;
        ASSERT_LT(lane, held.size());
        EXPECT_LE(held[lane], kQueue - kPixels) << "lane " << lane << " has no room";
        held[lane] += static_cast<long>(width * height);
        ++tiles[lane];
      }
    }
    for (int i = 0; i < kLanes; ++i) held[static_cast<std::size_t>(i)] -= left >> i & 1;
    if (offering && dut->in_ready_o) offering = false;
    dut.tick();
    ASSERT_FALSE(HasFailure()) << "cycle " << cycle;
  }
  for (const long count : tiles) EXPECT_GT(count, 100);
}

TEST_F(TileDeal, IdleLanesTakeTheirTurns) {
  for (int i = 0; i < kLanes; ++i) {
    offer(TileRoot);
    EXPECT_EQ(dut->deal_lane_o, i);
    dut.tick();
  }
  offer(TileTwo, 1, 1);
  EXPECT_FALSE(dut->in_ready_o) << "all queues are promised";
  dut->left_i = 0b010;   // the second lane's queue empties
  for (int i = 0; i < kQueue; ++i) dut.tick();
  dut->left_i = 0;
  offer(TileTwo, 1, 1);
  EXPECT_TRUE(dut->deal_valid_o);
  EXPECT_EQ(dut->deal_lane_o, 1);
}

TEST_F(TileDeal, EmptyTilesGivePixelsWhereEachMissIsWanted) {
  dut->each_miss_i = 1;
  offer(TileEmpty);
  EXPECT_TRUE(dut->pixels_valid_o && dut->miss_o && dut->in_ready_o);
  EXPECT_FALSE(dut->fill_valid_o || dut->deal_valid_o);
}

TEST_F(TileDeal, DirectTilesGoToNoLane) {
  dut->direct_i = 1;
  for (int i = 0; i < 10; ++i) {
    offer(i % 2 ? TileRoot : TileEmpty);
    EXPECT_TRUE(dut->pixels_valid_o && dut->in_ready_o && !dut->miss_o);
    EXPECT_FALSE(dut->fill_valid_o || dut->deal_valid_o);
    dut.tick();
  }
}

}  // namespace
}  // namespace castray::tb
