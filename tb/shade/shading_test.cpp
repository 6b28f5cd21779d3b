// SPDX-License-Identifier: Apache-2.0
// Hits of whole windows, in any order across the tiles in flight, become the bytes that the model writes
// to frame and hit buffer, and no others; idle and coloured say what is so in every cycle.
// Verilator: -GTileLog2=2 -GSlots=5 -GAttrEntries=8
#include "Vshading.h"
#include "camera/tile_walk.hpp"
#include "dut.hpp"
#include "mem/hit_writer.hpp"
#include "mem/image.hpp"
#include "shade/shade.hpp"
#include "stimulus.hpp"

namespace castray::tb {
namespace {

constexpr int kTileLog2 = 2, kSlots = 5, kAttributes = 40;
constexpr std::uint64_t kFrame = 0x1'0000'0040, kHits = 0x2'0000'0080, kAttrs = 0x3'0000'0100;
constexpr std::uint8_t kUntouched = 0xa5;

struct Buffer {
  std::uint64_t base;
  std::vector<std::uint8_t> bytes;

  void write(const write_req_t& req) {
    for (std::uint64_t i = 0; i < req.beats * StrbW; ++i) {
      if (!(req.strb >> i & 1)) continue;
      ASSERT_LT(req.addr + i - base, bytes.size()) << "a write outside the buffer";
      bytes[req.addr + i - base] = static_cast<std::uint8_t>(req.data[i / 4] >> (8 * (i % 4)));
    }
  }
};

class Shading : public testing::TestWithParam<Stalls> {
 protected:
  // The hit buffer takes nothing before the cycle `shut`.
  void run(std::uint64_t width, std::uint64_t height, bool want_hits, Stalls stalls, long shut = 0) {
    dut->tile_valid_i = dut->in_valid_i = dut->rsp_valid_i = 0;
    dut.reset();  // as between jobs: the attributes are others
    Stimulus stimulus(static_cast<unsigned>(width));
    job_t job;
    job.frame = kFrame, job.hits = kHits, job.want_hits = job.want_work = want_hits;
    job.width = job.x1 = width, job.height = job.y1 = height;
    frame_record_t record;
    record.stride = (width * PixelBytes + BufferAlign - 1) / BufferAlign * BufferAlign;
    record.background = 0x123456, record.colour_a = 0xfedcba, record.colour_b = 0x0f1e2d;
    record.checker_scale = 5 << CheckerFrac, record.pixel_format = want_hits;
    const point_t eye = stimulus.point();
    std::vector<attr_t> attrs(kAttributes);
    for (attr_t& attr : attrs) attr = stimulus.attr();
    set_port(dut->job_i, job);
    set_port(dut->record_i, record);
    set_port(dut->eye_i, eye);
    dut->attributes_i = kAttrs;

    Buffer frame{kFrame, std::vector<std::uint8_t>(record.stride * height, kUntouched)};
    Buffer hits{kHits, std::vector<std::uint8_t>(width * height * HitBytes, kUntouched)};
    Buffer want_frame = frame, want_records = hits;
    const paint_t paint = frame_paint(record);
    std::vector<tile_t> tiles;
    for_each_tile(job, kTileLog2, kSlots, [&](const tile_t& tile) { tiles.push_back(tile); });

    Gate ask(stalls.source, stalls.burst, 1), source(stalls.source, stalls.burst, 2), bus(stalls.sink, stalls.burst, 3);
    std::mt19937 rng(7);
    std::vector<cast_t> pool;   // of tiles that were granted
    std::deque<read_req_t> reads;
    int beat = 0;
    std::size_t asked = 0, given = 0;
    const std::size_t pixels = width * height;
    bool idle = true;
    for (long cycle = 0; cycle < 200000 && (given < pixels || !idle); ++cycle) {
      dut->tile_valid_i = asked < tiles.size() && (dut->tile_valid_i || ask.open());
      if (dut->tile_valid_i) set_port(dut->tile_i, tiles[asked]);
      if (!dut->in_valid_i && !pool.empty() && source.open()) {
        std::swap(pool[rng() % pool.size()], pool.back());
        dut->in_valid_i = 1;
        set_port(dut->in_i, offered_ = pool.back());
        pool.pop_back();
      }
      dut->read_ready_i = bus.open();
      dut->pixel_ready_i = bus.open();
      dut->record_ready_i = cycle >= shut && bus.open();
      dut->rsp_valid_i = !reads.empty() && bus.open();
      if (dut->rsp_valid_i) {
        const auto words = pack(attrs.at((reads.front().addr - kAttrs) / AttrBytes));
        read_rsp_t rsp;
        for (std::size_t i = 0; i < 4; ++i) rsp.data[i] = words[4 * static_cast<std::size_t>(beat) + i];
        rsp.last = ++beat == 4;
        if (rsp.last) beat = 0, reads.pop_front();
        set_port(dut->rsp_i, rsp);
      }
      dut.settle();
      idle = dut->idle_o;
      if (idle) ASSERT_TRUE(dut->coloured_o);
      if (idle && given == pixels) continue;
      if (dut->read_valid_o && dut->read_ready_i) reads.push_back(get_port<read_req_t>(dut->read_o));
      if (dut->pixel_valid_o && dut->pixel_ready_i) ASSERT_NO_FATAL_FAILURE(frame.write(get_port<write_req_t>(dut->pixel_o)));
      if (dut->record_valid_o && dut->record_ready_i) ASSERT_NO_FATAL_FAILURE(hits.write(get_port<write_req_t>(dut->record_o)));
      const bool took = dut->in_valid_i && dut->in_ready_o, granted = dut->tile_valid_i && dut->tile_ready_o;
      if (took) {
        const hit_t& hit = offered_.hit;
        const shaded_t shaded = hit.found ? shade(hit, attrs[hit.number], eye, paint) : background(hit, paint);
        const auto colour = static_cast<std::uint32_t>(shaded.colour);
        std::memcpy(&want_frame.bytes[hit.tag.y * record.stride + hit.tag.x * PixelBytes], &colour, PixelBytes);
        if (want_hits) store_record(&want_records.bytes[hit_offset(hit.tag, width)], hit_record(hit, offered_.work));
        ++given;
      }
      if (granted) {
        tiles[asked].slot = dut->tile_slot_o;
        for_each_pixel(tiles[asked], [&](const pixel_tag_t& tag) {
          hit_t hit = stimulus.hit();
          hit.tag = tag;
          hit.found = stimulus.bits(2) != 0;
          hit.number = stimulus.bits(16) % kAttributes;
          pool.push_back({.work = {.tests = stimulus.bits(20), .nodes = stimulus.bits(20)}, .hit = hit});
        });
        ++asked;
      }
      dut.tick();
      if (took) dut->in_valid_i = 0;
      if (granted) dut->tile_valid_i = 0;
      dut.settle();
      if (took) ASSERT_FALSE(dut->coloured_o) << "a hit came";
    }
    EXPECT_EQ(given, pixels);
    EXPECT_TRUE(idle);
    EXPECT_TRUE(frame.bytes == want_frame.bytes);
    EXPECT_TRUE(hits.bytes == want_records.bytes);
  }

  Dut<Vshading> dut;
  cast_t offered_;
};
INSTANTIATE_TEST_SUITE_P(Stalls, Shading, testing::ValuesIn(kStallPatterns));

TEST_P(Shading, WritesWhatTheModelWrites) {
  run(33, 18, true, GetParam());
  run(20, 7, false, GetParam());
  run(1, 1, true, GetParam());
}

// Records at the rays' numbers, and nothing of a picture.
TEST_P(Shading, WritesOfAListItsRecordsOnly) {
  constexpr std::size_t kRays = 400;
  Stimulus stimulus(3);
  job_t job;
  job.hits = kHits, job.is_list = job.want_hits = job.want_work = 1;
  job.width = job.height = 7;   // are not looked at
  dut->tile_valid_i = dut->in_valid_i = dut->rsp_valid_i = dut->fill_valid_i = 0;
  dut.reset();
  set_port(dut->job_i, job);
  Buffer hits{kHits, std::vector<std::uint8_t>(8192 * HitBytes, kUntouched)};
  Buffer want = hits;
  Gate source(GetParam().source, GetParam().burst, 2), bus(GetParam().sink, GetParam().burst, 3);
  std::size_t given = 0;
  for (long cycle = 0; cycle < 20000 && (given < kRays || !dut->idle_o); ++cycle) {
    if (!dut->in_valid_i && given < kRays && source.open()) {
      const std::uint64_t number = given * 37 % 8192;
      hit_t hit = stimulus.hit();
      hit.tag = {.x = number % MaxFrameSize, .y = number / MaxFrameSize};
      hit.found = stimulus.bits(2) != 0, hit.any_hit = stimulus.bits(1);
      offered_ = {.work = {.tests = stimulus.bits(20), .nodes = stimulus.bits(20)}, .hit = hit};
      store_record(&want.bytes[number * HitBytes], hit_record(hit, offered_.work));
      dut->in_valid_i = 1;
      set_port(dut->in_i, offered_);
    }
    dut->read_ready_i = dut->pixel_ready_i = 1;
    dut->record_ready_i = bus.open();
    dut.settle();
    ASSERT_FALSE(dut->read_valid_o || dut->pixel_valid_o);
    if (dut->record_valid_o && dut->record_ready_i) ASSERT_NO_FATAL_FAILURE(hits.write(get_port<write_req_t>(dut->record_o)));
    const bool took = dut->in_valid_i && dut->in_ready_o;
    given += took;
    dut.tick();
    if (took) dut->in_valid_i = 0;
    dut.settle();
    if (took) ASSERT_FALSE(dut->idle_o) << "a hit came";
  }
  EXPECT_EQ(given, kRays);
  EXPECT_TRUE(dut->idle_o);
  EXPECT_TRUE(hits.bytes == want.bytes);
}

TEST_F(Shading, WaitsForTheRecords) { run(2, 1, true, {}, 300); }

}  // namespace
}  // namespace castray::tb
