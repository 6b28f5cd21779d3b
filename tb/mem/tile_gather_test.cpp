// SPDX-License-Identifier: Apache-2.0
// Tiles of 4, 8 and 16 pixels and windows of any place: every pixel is written once, nothing else.
#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include "Vtile_gather.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

struct Unit {
  const char* name;
  int select, log2, slots;
};
constexpr Unit kUnits[] = {{"tile4", 0, 2, 16}, {"tile8", 1, 3, 16}, {"tile16of3", 2, 4, 3}, {"tile8of1", 3, 3, 1}};
void PrintTo(const Unit& unit, std::ostream* os) { *os << unit.name; }

struct Window {
  int x0, y0, x1, y1;
};
std::vector<tile_t> tiles_of(const Window& w, const Unit& unit) {
  const int size = 1 << unit.log2;
  std::vector<tile_t> tiles;
  for (int ty = w.y0 / size * size; ty < w.y1; ty += size)
    for (int tx = w.x0 / size * size; tx < w.x1; tx += size) {
      tile_t t;
      t.x = std::max(tx, w.x0), t.y = std::max(ty, w.y0);
      t.width = std::min(tx + size, w.x1) - t.x, t.height = std::min(ty + size, w.y1) - t.y;
      tiles.push_back(t);
    }
  return tiles;
}
std::uint32_t colour_of(std::uint64_t x, std::uint64_t y) {
  return static_cast<std::uint32_t>((y << 16 | x) * 2654435761u) | 1;
}

constexpr std::uint32_t kFill = 0x80604020;
constexpr std::uint64_t kBase = 0xf0'0000'0040;

class TileGather : public testing::TestWithParam<std::tuple<Unit, Stalls>> {
 protected:
  // Gathers the tiles; their pixels come in a random order across all tiles that have a slot, or
  // in the order of the walk. Returns the cycles it took.
  long run(const Unit& unit, const std::vector<tile_t>& tiles, std::uint64_t stride, Stalls stalls = {}, bool shuffled = true) {
    const unsigned size = 1u << unit.log2;
    Gate ask(stalls.source, stalls.burst, 1), source(stalls.source, stalls.burst, 2), sink(stalls.sink, stalls.burst, 3);
    std::mt19937 rng(4);
    dut_->select_i = unit.select;
    dut_->base_i = kBase;
    dut_->stride_i = stride;
    dut_->tile_valid_i = dut_->in_valid_i = dut_->fill_valid_i = dut_->out_ready_i = 0;
    dut_->fill_colour_i = kFill;
    std::deque<std::uint64_t> fills;         // slots of tiles to be filled
    // Rows still to be written: address -> (strobes, pixels of the row).
    struct Row {
      std::uint64_t x, y, strb = 0;
      bool filled = false;
    };
    std::map<std::uint64_t, Row> rows;
    std::map<std::uint64_t, int> rows_left;  // of each slot
    std::deque<pixel_tag_t> pixels;
    std::size_t asked = 0, total = 0;
    bool asking = false;
    for (const tile_t& t : tiles) total += t.height;
    std::size_t written = 0;
    std::optional<write_req_t> held;
    const long start = dut_.cycles(), limit = 20000 + 40L * static_cast<long>(tiles.size()) * size * size;
    while (written < total && dut_.cycles() - start < limit && !testing::Test::HasFailure()) {
      asking = asking || (asked < tiles.size() && ask.open());
      dut_->tile_valid_i = asking;
      if (asking) set_port(dut_->tile_i, tiles[asked]);
      std::size_t pick = 0;
      dut_->in_valid_i = !pixels.empty() && source.open();
      if (dut_->in_valid_i) {
        if (shuffled) pick = rng() % pixels.size();
        shaded_t s;
        s.tag = pixels[pick];
        s.colour = colour_of(s.tag.x, s.tag.y);
        set_port(dut_->in_i, s);
      }
      if (!dut_->fill_valid_i) dut_->fill_valid_i = !fills.empty() && source.open();
      if (!fills.empty()) dut_->fill_slot_i = static_cast<std::uint8_t>(fills.front());
      dut_->out_ready_i = sink.open();
      dut_.settle();
      EXPECT_EQ(dut_->idle_o, rows_left.empty());
      if (dut_->out_valid_o) {
        const auto req = get_port<write_req_t>(dut_->out_o);
        if (held) EXPECT_TRUE(req == *held) << "an untaken row changed";
        held = req;
        if (dut_->out_ready_i) {
          held.reset();
          ++written;
          const auto row = rows.find(req.addr);
          EXPECT_NE(row, rows.end()) << "address " << std::hex << req.addr << std::dec;
          if (row == rows.end()) break;
          EXPECT_EQ(req.beats, size / 4);
          EXPECT_EQ(req.strb, row->second.strb);
          for (unsigned i = 0; i < size; ++i)
            if (req.strb >> (4 * i) & 1) EXPECT_EQ(req.data[i], row->second.filled ? kFill : colour_of(row->second.x + i, row->second.y)) << i;
          for (auto slot = rows_left.begin(); slot != rows_left.end(); ++slot)
            if (owner_[req.addr] == slot->first && --slot->second == 0) {
              rows_left.erase(slot);
              break;
            }
          rows.erase(row);
        }
      } else {
        EXPECT_FALSE(held) << "an untaken row was dropped";
        held.reset();
      }
      if (dut_->in_valid_i) {
        EXPECT_TRUE(dut_->in_ready_o) << "a pixel was refused";
        pixels.erase(pixels.begin() + static_cast<long>(pick));
      }
      if (asking && dut_->tile_ready_o) {
        tile_t t = tiles[asked++];
        t.slot = dut_->tile_slot_o;
        EXPECT_LT(t.slot, static_cast<unsigned>(unit.slots));
        EXPECT_EQ(rows_left.count(t.slot), 0u) << "a slot was given away";
        rows_left[t.slot] = static_cast<int>(t.height);
        const bool filled = fill_every > 0 && asked % static_cast<std::size_t>(fill_every) == 0;
        if (filled) fills.push_back(t.slot);
        for (std::uint64_t y = t.y; y < t.y + t.height; ++y) {
          Row row{t.x / size * size, y, 0, filled};
          for (std::uint64_t x = t.x; x < t.x + t.width; ++x) {
            row.strb |= std::uint64_t{15} << (4 * (x - row.x));
            pixel_tag_t tag;
            tag.x = x, tag.y = y, tag.slot = t.slot;
            if (!filled) pixels.push_back(tag);
          }
          const std::uint64_t addr = (kBase + y * stride + row.x * 4) % (std::uint64_t{1} << AddrW);
          EXPECT_EQ(rows.count(addr), 0u);
          rows[addr] = row;
          owner_[addr] = t.slot;
        }
        asking = false;
      }
      const bool took_fill = dut_->fill_valid_i && dut_->fill_ready_o;
      dut_.tick();
      if (took_fill) fills.pop_front(), dut_->fill_valid_i = 0;
    }
    EXPECT_EQ(written, total);
    dut_->tile_valid_i = dut_->in_valid_i = dut_->fill_valid_i = dut_->out_ready_i = 0;
    dut_.settle();
    EXPECT_TRUE(dut_->idle_o);
    return dut_.cycles() - start;
  }
  int fill_every = 0;   // each so many tiles one is filled
  std::map<std::uint64_t, std::uint64_t> owner_;  // address of a row -> slot
  Dut<Vtile_gather> dut_;
};

TEST_P(TileGather, WritesEachPixelOnce) {
  const auto& [unit, stalls] = GetParam();
  run(unit, tiles_of({0, 0, 64, 48}, unit), 256, stalls);
  run(unit, tiles_of({3, 5, 50, 39}, unit), 4096, stalls);   // partial on all four sides
  run(unit, tiles_of({17, 18, 18, 19}, unit), 128, stalls);  // one pixel
  run(unit, tiles_of({6, 1, 11, 30}, unit), 64, stalls, false);
}
INSTANTIATE_TEST_SUITE_P(Units, TileGather, testing::Combine(testing::ValuesIn(kUnits), testing::ValuesIn(kStallPatterns)),
                         [](const auto& info) { return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name; });

TEST_P(TileGather, FillsTilesBetweenOthers) {
  const auto& [unit, stalls] = GetParam();
  for (fill_every = 1; fill_every <= 3; ++fill_every) run(unit, tiles_of({3, 5, 50, 39}, unit), 4096, stalls);
}

TEST_F(TileGather, ReachesTheLastPixelOfTheLargestFrame) {
  for (const Unit& unit : kUnits) {
    run(unit, tiles_of({4090, 4089, 4096, 4096}, unit), 16384);
    run(unit, tiles_of({4090, 4089, 4096, 4096}, unit), 0xffffffc0);  // the widest stride: addresses wrap
  }
}

TEST_F(TileGather, HoldsEverySlotWhileBlocked) {
  for (const Unit& unit : kUnits) {
    dut_.reset(1);
    dut_->select_i = unit.select;
    dut_->in_valid_i = dut_->fill_valid_i = dut_->out_ready_i = 0;
    int granted = 0;
    for (int i = 0; i < unit.slots + 5; ++i) {
      tile_t t;
      t.x = 16 * granted, t.width = t.height = 1;
      dut_->tile_valid_i = 1;
      set_port(dut_->tile_i, t);
      dut_.settle();
      if (dut_->tile_ready_o) EXPECT_EQ(dut_->tile_slot_o, granted) << "from 0 up after a reset";
      granted += dut_->tile_ready_o;
      dut_.tick();
    }
    EXPECT_EQ(granted, unit.slots) << unit.name;
    // All complete, none taken: still none free.
    dut_->tile_valid_i = 0;
    for (int i = 0; i < granted; ++i) {
      shaded_t s;
      s.tag.x = 16 * i, s.tag.slot = i;
      dut_->in_valid_i = 1;
      set_port(dut_->in_i, s);
      dut_.tick();
    }
    dut_->in_valid_i = 0;
    for (int i = 0; i < 50; ++i) dut_.tick();
    EXPECT_TRUE(dut_->out_valid_o);
    EXPECT_FALSE(dut_->tile_ready_o);
  }
}

TEST_F(TileGather, KeepsUpWithAPixelACycle) {
  for (const Unit& unit : {kUnits[0], kUnits[1]}) {
    const long cycles = run(unit, tiles_of({0, 0, 128, 32}, unit), 512, {}, false);
    EXPECT_LE(cycles, 128 * 32 * 21 / 20 + 120) << unit.name;
  }
}

TEST_F(TileGather, StartsCleanAfterAReset) {
  for (const Unit& unit : kUnits) {
    for (int cycles = 3; cycles < 40; cycles += 5) {
      dut_->select_i = unit.select;
      dut_.reset(1);   // the first tile gets slot 0
      const auto tiles = tiles_of({0, 0, 16, 16}, unit);
      for (int i = 0; i < cycles; ++i) {  // a tile's first pixels, and rows of it if it is small
        dut_->tile_valid_i = i == 0;
        set_port(dut_->tile_i, tiles[0]);
        dut_->in_valid_i = i > 0 && i <= static_cast<int>(tiles[0].width * tiles[0].height);
        shaded_t s;
        s.tag.x = (i - 1) % tiles[0].width, s.tag.y = (i - 1) / tiles[0].width;
        set_port(dut_->in_i, s);
        dut_->out_ready_i = i & 1;
        dut_.tick();
      }
      dut_->tile_valid_i = dut_->in_valid_i = dut_->fill_valid_i = 0;
      dut_.reset(1);
      run(unit, tiles, 64);
    }
  }
}

}  // namespace
}  // namespace castray::tb
