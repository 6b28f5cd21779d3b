// SPDX-License-Identifier: Apache-2.0
// The rows of tiles of 4, 8 and 16 pixels: address, strobes and pixels of each, and how long they take.
#include <optional>

#include "Vtile_rows.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr std::uint64_t kBase = 0xf0'0000'0040;

// What the gather's memory holds in pixel x of a row of a slot's place.
std::uint32_t pixel(unsigned slot, unsigned row, unsigned x) { return (slot << 16 | row << 8 | x) * 2654435761u + 1; }

tile_t tile_of(unsigned slot, unsigned x, unsigned y, unsigned width, unsigned height) {
  tile_t t;
  t.slot = slot, t.x = x, t.y = y, t.width = width, t.height = height;
  return t;
}

class TileRows : public testing::TestWithParam<std::tuple<int, Stalls>> {
 protected:
  static constexpr int kSizes[3] = {4, 8, 16};

  // Writes the tiles one after another; every row must be what the tile says. Returns the cycles from
  // the first tile's being taken to the last row's.
  long run(int size, const std::vector<tile_t>& tiles, std::uint64_t stride, Stalls stalls = {}) {
    Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2);
    select(size);
    dut_->base_i = kBase, dut_->stride_i = stride;
    std::size_t asked = 0, done = 0;
    unsigned row = 0;
    bool asking = false;
    std::optional<write_req_t> held;
    long first = 0, last = 0;
    for (long cycle = 0; done < tiles.size() && cycle < 40000 && !HasFailure(); ++cycle) {
      asking = asking || (asked < tiles.size() && source.open());
      dut_->tile_valid_i = asking;
      if (asking) set_port(dut_->tile_i, tiles[asked]);
      dut_->out_ready_i = sink.open();
      dut_.settle();
      if (dut_->out_valid_o) {
        const auto req = get_port<write_req_t>(dut_->out_o);
        if (held) EXPECT_TRUE(req == *held) << "an untaken row changed";
        held = req;
        const tile_t& t = tiles[done];
        expect_row(size, t, row, stride, req);
        EXPECT_EQ(dut_->slot_o, t.slot);
        EXPECT_EQ(dut_->done_o, dut_->out_ready_i && row + 1 == t.height);
        if (dut_->out_ready_i) {
          held.reset();
          last = cycle;
          if (++row == t.height) row = 0, ++done;
        }
      } else {
        EXPECT_FALSE(held) << "an untaken row was dropped";
        EXPECT_FALSE(dut_->done_o);
      }
      if (asking && dut_->tile_ready_o) {
        EXPECT_EQ(asked, done) << "a tile was taken while another is written";
        if (asked++ == 0) first = cycle;
        asking = false;
      }
      tick();
    }
    EXPECT_EQ(done, tiles.size());
    dut_->tile_valid_i = dut_->out_ready_i = 0;
    return last - first;
  }
  void select(int size) { dut_->select_i = size == 4 ? 0 : size == 8 ? 1 : 2; }
  // One cycle, with the memory: what is read comes a cycle later, else it is anything.
  void tick() {
    const bool read = dut_->read_o;
    const unsigned slot = dut_->slot_o, row = dut_->row_o, beat = dut_->beat_o;
    dut_.tick();
    for (unsigned i = 0; i < 4; ++i) dut_->beat_i[i] = read ? pixel(slot, row, 4 * beat + i) : 0xdeadbeef;
  }
  Dut<Vtile_rows> dut_;

 private:
  static void expect_row(int size, const tile_t& t, unsigned row, std::uint64_t stride, const write_req_t& req) {
    const std::uint64_t x0 = t.x / size * size, y = t.y + row;
    EXPECT_EQ(req.addr, (kBase + y * stride + 4 * x0) % (std::uint64_t{1} << AddrW)) << "row " << y;
    EXPECT_EQ(req.beats, static_cast<unsigned>(size / 4));
    std::uint64_t strobes = 0;
    for (std::uint64_t x = t.x; x < t.x + t.width; ++x) strobes |= std::uint64_t{15} << (4 * (x - x0));
    EXPECT_EQ(req.strb, strobes) << "row " << y;
    for (int i = 0; i < size; ++i) EXPECT_EQ(req.data[i], pixel(t.slot, y % size, i)) << "row " << y << " pixel " << i;
  }
};

TEST_P(TileRows, WritesWholeAndClippedTiles) {
  const auto& [size, stalls] = GetParam();
  std::mt19937 rng(5);
  std::vector<tile_t> tiles{tile_of(0, 0, 0, size, size), tile_of(255, 4096 - size, 4096 - size, size, size)};
  for (int i = 0; i < 200; ++i) {
    const unsigned left = rng() % size, top = rng() % size;
    tiles.push_back(tile_of(rng() % 256, rng() % (4096 / size) * size + left, rng() % (4096 / size) * size + top,
                            1 + rng() % (size - left), 1 + rng() % (size - top)));
  }
  run(size, tiles, 16384, stalls);
}
INSTANTIATE_TEST_SUITE_P(Sizes, TileRows, testing::Combine(testing::Values(4, 8, 16), testing::ValuesIn(kStallPatterns)),
                         [](const auto& info) { return "tile" + std::to_string(std::get<0>(info.param)) + "_" + std::get<1>(info.param).name; });

TEST_F(TileRows, StrobesOnlyTheTilesOwnPixels) {
  for (const int size : kSizes)
    for (int left = 0; left < size; ++left)
      for (int width = 1; left + width <= size; ++width) run(size, {tile_of(9, 2 * size + left, size, width, 1)}, 64);
}

TEST_F(TileRows, ReadsAClippedTilesOwnRows) {
  for (const int size : kSizes)
    for (int top = 0; top < size; ++top) run(size, {tile_of(1, 0, 3 * size + top, size, size - top)}, 128);
}

TEST_F(TileRows, AddressesWrapAtTheWidestStride) {
  for (const int size : kSizes) run(size, {tile_of(2, 4095, 4096 - size, 1, size)}, 0xffffffc0);
}

TEST_F(TileRows, TakesSizeOverFourCyclesARow) {
  for (const int size : kSizes) {
    const int beats = size / 4, first = 4 + beats;
    const int last = first + (size == 4 ? 4 : (size - 1) * beats);   // two rows of a beat take three cycles
    EXPECT_EQ(run(size, {tile_of(0, 0, 0, size, size)}, 64), last);
    EXPECT_EQ(run(size, {tile_of(0, 0, 0, size, size), tile_of(1, size, 0, size, 1)}, 64), last + 1 + first);
  }
}

TEST_F(TileRows, ResetEmptiesIt) {
  for (const int size : kSizes)
    for (int cycles = 1; cycles < 12; ++cycles) {
      select(size);
      dut_->tile_valid_i = 1, dut_->out_ready_i = 1;
      set_port(dut_->tile_i, tile_of(7, 0, 0, size, size));
      for (int i = 0; i < cycles; ++i) tick();
      dut_->tile_valid_i = 0;
      dut_.reset(1);
      EXPECT_TRUE(dut_->tile_ready_o);
      EXPECT_FALSE(dut_->out_valid_o || dut_->read_o || dut_->done_o);
      run(size, {tile_of(3, size + 1, 1, 2, 2)}, 256);
    }
}

}  // namespace
}  // namespace castray::tb
