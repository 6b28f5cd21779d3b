// SPDX-License-Identifier: Apache-2.0
// Runs long.
// tile_walk: the model's walk has the properties asked of it, and the RTL is the model's walk.
#include "Vtile_walk.h"
#include "camera/tile_walk.hpp"
#include "dut.hpp"
#include "windows.hpp"

namespace castray::tb {
namespace {

constexpr int kSlots[] = {5, 16, 256};  // that tiles of 4, 8 and 16 are given in turn

job_t frame(std::uint64_t width, std::uint64_t height, bool z_order) { return window(width, height, 0, 0, width, height, z_order); }

// Whole frames, windows with partial tiles on each side, windows inside one tile.
std::vector<job_t> jobs() {
  std::vector<job_t> all;
  for (const bool z : {false, true}) {
    for (const auto& [w, h] : {std::array{1u, 1u}, {7u, 5u}, {33u, 17u}, {64u, 64u}, {80u, 60u}, {1u, 300u}, {300u, 1u}, {200u, 40u}})
      all.push_back(frame(w, h, z));
    all.push_back(window(64, 64, 3, 5, 4, 6, z));
    all.push_back(window(64, 64, 3, 5, 61, 59, z));
    all.push_back(window(64, 64, 15, 17, 49, 33, z));
    all.push_back(window(4096, 4096, 4095, 4095, 4096, 4096, z));
    all.push_back(window(4096, 4096, 4001, 4050, 4096, 4096, z));
  }
  return all;
}

std::uint64_t interleave(std::uint64_t column, std::uint64_t row) {
  std::uint64_t code = 0;
  for (int bit = 0; bit < 12; ++bit) code |= ((column >> bit) & 1) << (2 * bit) | ((row >> bit) & 1) << (2 * bit + 1);
  return code;
}

// Every pixel of the window once, tile by tile, the tiles in order, row by row inside.
void expect_properties(const job_t& job, int tile_log2, int slots) {
  SCOPED_TRACE(to_text(job) + " tile_log2=" + std::to_string(tile_log2));
  const std::uint64_t mask = (1u << tile_log2) - 1;
  std::vector<bool> seen((job.x1 - job.x0) * (job.y1 - job.y0));
  std::size_t pixels = 0;
  long tiles = 0;
  long wrong = 0;
  pixel_tag_t last;
  std::uint64_t last_key = 0;
  tile_walk(job, tile_log2, slots, [&](const pixel_tag_t& tag) {
    if (tag.x < job.x0 || tag.x >= job.x1 || tag.y < job.y0 || tag.y >= job.y1) return void(++wrong);
    const std::size_t at = (tag.y - job.y0) * (job.x1 - job.x0) + tag.x - job.x0;
    wrong += seen[at];
    seen[at] = true;
    const std::uint64_t column = (tag.x >> tile_log2) - (job.x0 >> tile_log2), row = (tag.y >> tile_log2) - (job.y0 >> tile_log2);
    const std::uint64_t key = job.z_order ? interleave(column, row) : row << 12 | column;
    const bool fresh = pixels == 0 || key != last_key;
    tiles += fresh;
    if (fresh) {
      wrong += pixels != 0 && key < last_key;
      wrong += tag.x != std::max(job.x0, tag.x & ~mask) || tag.y != std::max(job.y0, tag.y & ~mask);
    } else {
      wrong += !(tag.y == last.y && tag.x == last.x + 1) && !(tag.y == last.y + 1 && tag.x == std::max(job.x0, tag.x & ~mask));
    }
    wrong += tag.slot != static_cast<std::uint64_t>((tiles - 1) % slots);
    last = tag;
    last_key = key;
    ++pixels;
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(pixels, seen.size());
}

TEST(TileWalkModel, VisitsEachPixelOnceInTilesInOrder) {
  for (int i = 0; i < 3; ++i)
    for (const job_t& job : jobs()) expect_properties(job, 2 + i, kSlots[i]);
}

TEST(TileWalkModel, VisitsEachPixelOfTheLargestFrameOnce) {
  for (int i = 0; i < 3; ++i) expect_properties(frame(4096, 4096, i != 1), 2 + i, kSlots[i]);
}

TEST(TileWalkModel, FollowsTheZCurve) {
  // A window of 3 x 2 tiles of 4: (0,0) (1,0) (0,1) (1,1) (2,0) (2,1).
  std::vector<std::array<std::uint64_t, 2>> order;
  for_each_tile(frame(12, 8, true), 2, 8, [&](const tile_t& tile) { order.push_back({tile.x / 4, tile.y / 4}); });
  EXPECT_EQ(order, (std::vector<std::array<std::uint64_t, 2>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {2, 1}}));
}

class TileWalk : public ::testing::TestWithParam<Stalls> {
 protected:
  void start(int size, const job_t& job) {
    dut->select_i = static_cast<unsigned char>(size);
    dut->tile_ready_i = dut->out_ready_i = 0;
    set_port(dut->job_i, job);
    dut->start_i = 1;
    dut.tick();
    dut->start_i = 0;
  }

  // Follows a whole walk; the pixels of a tile come only after the tile was granted.
  void follow(int size, const job_t& job, Stalls stalls = {}) {
    SCOPED_TRACE(to_text(job) + " size " + std::to_string(size));
    std::vector<tile_t> tiles;
    for_each_tile(job, 2 + size, kSlots[size], [&](const tile_t& tile) { tiles.push_back(tile); });
    Gate gather(stalls.source, stalls.burst, 5), sink(stalls.sink, stalls.burst, 6);
    start(size, job);
    std::size_t granted = 0, given = 0;  // tiles
    std::size_t pixels = 0;              // of tile `given`
    bool tile_held = false, out_held = false;
    const std::size_t area = (job.x1 - job.x0) * (job.y1 - job.y0);
    const long limit = 1000 + 8 * static_cast<long>(area + 24 * tiles.size());
    long cycle = 0;
    for (; cycle < limit && !(given == tiles.size() && granted == tiles.size()); ++cycle) {
      dut->tile_ready_i = gather.open();
      dut->out_ready_i = sink.open();
      if (granted < tiles.size()) dut->tile_slot_i = static_cast<std::uint8_t>(tiles[granted].slot);
      dut.settle();
      ASSERT_FALSE(dut->done_o);
      ASSERT_FALSE(tile_held && !dut->tile_valid_o) << "a request was dropped";
      ASSERT_FALSE(out_held && !dut->out_valid_o) << "a pixel was dropped";
      tile_held = dut->tile_valid_o && !dut->tile_ready_i;
      out_held = dut->out_valid_o && !dut->out_ready_i;
      if (dut->out_valid_o) {
        ASSERT_LT(given, granted) << "a pixel of a tile that was not granted";
        const tile_t& tile = tiles[given];
        const pixel_tag_t want = {.x = tile.x + pixels % tile.width, .y = tile.y + pixels / tile.width, .slot = tile.slot};
        const auto got = get_port<pixel_tag_t>(dut->out_o);
        ASSERT_TRUE(got == want) << to_text(got) << " instead of " << to_text(want);
        if (dut->out_ready_i && ++pixels == tile.width * tile.height) {
          pixels = 0;
          ++given;
        }
      }
      if (dut->tile_valid_o) {
        ASSERT_LT(granted, tiles.size());
        auto got = get_port<tile_t>(dut->tile_o);
        ASSERT_EQ(got.slot, 0u);
        got.slot = tiles[granted].slot;
        ASSERT_TRUE(got == tiles[granted]) << to_text(got) << " instead of " << to_text(tiles[granted]);
        granted += dut->tile_ready_i;
      }
      dut.tick();
    }
    ASSERT_EQ(given, tiles.size());
    for (int i = 0; i < 30 && !dut->done_o; ++i) {  // the rest of the Z curve is skipped
      EXPECT_FALSE(dut->tile_valid_o);
      dut.tick();
    }
    EXPECT_TRUE(dut->done_o);
    EXPECT_FALSE(dut->out_valid_o);
    cycles_ = cycle;
  }

  Dut<Vtile_walk> dut;
  long cycles_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Stalls, TileWalk, ::testing::ValuesIn(kStallPatterns));

TEST_P(TileWalk, MatchesModel) {
  for (int size = 0; size < 3; ++size)
    for (const job_t& job : jobs()) follow(size, job, GetParam());
}

TEST_P(TileWalk, MatchesModelOnRandomWindows) {
  std::mt19937 rng(7);
  for (int i = 0; i < 300; ++i) {
    const std::uint64_t width = 1 + rng() % (i % 10 ? 100 : 4096), height = 1 + rng() % (i % 10 ? 100 : 4096);
    const std::uint64_t x0 = rng() % width, y0 = rng() % height;
    const std::uint64_t x1 = x0 + 1 + rng() % std::min<std::uint64_t>(width - x0, 90);
    const std::uint64_t y1 = y0 + 1 + rng() % std::min<std::uint64_t>(height - y0, 60);
    follow(i % 3, window(width, height, x0, y0, x1, y1, i & 4), GetParam());
  }
}

TEST_F(TileWalk, MatchesModelAcrossTheLargestFrameAPixelACycle) {
  for (const job_t& job : {window(4096, 4096, 0, 1920, 4096, 2048, true), window(4096, 4096, 3968, 0, 4096, 4096, false)}) {
    follow(1, job);
    EXPECT_EQ(cycles_, 4096L * 128 + 3);
  }
}

TEST_F(TileWalk, SkipsWhatLiesOutsideTheWindowInBlocks) {
  // One column, one row, and one more than a power of two: the most that is skipped at once.
  for (const job_t& job : {window(4096, 4096, 0, 0, 1, 4096, true), window(4096, 4096, 0, 0, 4096, 1, true), frame(516, 516, true)}) {
    start(0, job);
    dut->tile_ready_i = dut->out_ready_i = 1;
    int pause = 0, longest = 0;
    for (int cycle = 0; cycle < 400000 && !dut->done_o; ++cycle) {
      dut.settle();
      pause = dut->out_valid_o ? 0 : pause + 1;
      longest = std::max(longest, pause);
      dut.tick();
    }
    EXPECT_TRUE(dut->done_o);
    EXPECT_LE(longest, 20);
  }
}

TEST_F(TileWalk, FillsItsPlacesWhileBlocked) {
  // The sink shut: one tile on its way out, one waiting, a third one asked for but not granted.
  start(1, frame(64, 64, false));
  dut->tile_ready_i = 1;
  int granted = 0;
  for (int i = 0; i < 50; ++i) {
    dut.settle();
    granted += dut->tile_valid_o;
    dut.tick();
  }
  EXPECT_EQ(granted, 2);
}

TEST_F(TileWalk, WaitsForTheGather) {
  start(1, frame(64, 64, false));
  dut->out_ready_i = 1;
  for (int i = 0; i < 50; ++i) {
    dut.settle();
    EXPECT_FALSE(dut->out_valid_o);
    EXPECT_EQ(dut->tile_valid_o, i >= 1);
    dut.tick();
  }
}

TEST_F(TileWalk, IsNotDoneBeforeItsFirstStartAndStartsAfresh) {
  dut->select_i = 1;
  dut.settle();
  EXPECT_FALSE(dut->done_o);
  for (int at = 0; at < 40; ++at) {
    start(1, frame(33, 17, at & 1));
    dut->tile_ready_i = dut->out_ready_i = 1;
    for (int i = 0; i < at; ++i) dut.tick();
    if (at % 4 == 3) {
      dut.reset();
      EXPECT_FALSE(dut->done_o || dut->tile_valid_o || dut->out_valid_o);
    }
    follow(1, frame(20, 9, at & 2));
  }
}

TEST_F(TileWalk, OfAnEmptyWindowIsDoneAtOnce) {
  for (const job_t& job : {window(8, 8, 4, 0, 4, 8, false), window(8, 8, 0, 5, 8, 5, true), window(8, 8, 6, 0, 2, 8, true)}) {
    start(1, job);
    dut.settle();
    EXPECT_TRUE(dut->done_o);
  }
}

}  // namespace
}  // namespace castray::tb
