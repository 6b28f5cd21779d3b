// SPDX-License-Identifier: Apache-2.0
// prim_reader against its model, over a read client with latency, gaps and refusals.
#include "Vprim_reader.h"
#include "dut.hpp"
#include "mem/prim_reader.hpp"

namespace castray::tb {
namespace {

constexpr int kDepth = 32;            // slots in the queue
constexpr std::uint64_t kBase = 0xff'1234'5600;  // of the image; the lines cross pages of 4 KiB
constexpr std::uint64_t kLines = 256;            // offset of the lines in the image

// An image of `lines` lines whose slots are filled by fill(index).
struct Image {
  image_header_t header;
  std::vector<std::uint8_t> bytes;

  template <class Fill> Image(std::uint64_t lines, std::uint64_t primitives, Fill&& fill) {
    header.lines = {.offset = kLines, .count = lines};
    header.primitives = primitives;
    bytes.resize(kLines + lines * LineBytes);
    for (std::uint64_t i = 0; i < slot_count(header); ++i) store_record(&bytes[kLines + i * SlotBytes], fill(i));
  }
};

prim_slot_t slot_of(std::uint64_t number, std::mt19937_64& rng) {
  packed_t<prim_slot_t> words;
  for (auto& word : words) word = static_cast<std::uint32_t>(rng());
  prim_slot_t slot = unpack<prim_slot_t>(words.data());
  slot.number = number;
  return slot;
}
Image random_image(std::uint64_t lines, double empty, unsigned seed) {
  std::mt19937_64 rng(seed);
  std::uniform_real_distribution<double> chance(0, 1);
  return Image(lines, 2 * lines, [&](std::uint64_t i) { return slot_of(chance(rng) < empty ? NoPrim : i, rng); });
}

class PrimReader : public ::testing::TestWithParam<Stalls> {
 protected:
  struct Beat {
    long due;
    read_rsp_t rsp;
  };

  void start(const Image& image) {
    set_port(dut->base_i, kBase + kLines);
    set_port(dut->lines_i, image.header.lines.count);
    set_port(dut->primitives_i, image.header.primitives);
    dut->start_i = 1;
    dut->req_ready_i = dut->rsp_valid_i = dut->out_ready_i = 0;
    dut.tick();
    dut->start_i = 0;
    next_ = kLines;
    faults_ = 0;
    beats_.clear();
  }

  // One cycle; slots that were taken go to `got`.
  void cycle(const Image& image, bool grant, bool respond, bool take, long latency, std::vector<prim_slot_t>& got) {
    dut->req_ready_i = grant;
    dut->out_ready_i = take;
    dut->rsp_valid_i = respond && !beats_.empty() && beats_.front().due <= dut.cycles();
    if (dut->rsp_valid_i) {
      set_port(dut->rsp_i, beats_.front().rsp);
      beats_.pop_front();
    }
    dut.settle();
    faults_ += dut->fault_o == ErrPrimitive;
    if (dut->req_valid_o && grant) {
      const auto req = get_port<read_req_t>(dut->req_o);
      ASSERT_EQ(req.addr, kBase + next_) << "lines are asked for once, in order";
      ASSERT_EQ(req.addr % 256, 0u);
      ASSERT_TRUE(req.beats >= 4 && req.beats <= 16 && req.beats % 4 == 0);
      ASSERT_LE(next_ + req.beats * 16, image.bytes.size()) << "beyond the lines";
      for (std::uint64_t i = 0; i < req.beats; ++i) {
        Beat beat{dut.cycles() + latency, {}};
        std::memcpy(beat.rsp.data.data(), &image.bytes[next_ + 16 * i], 16);
        beat.rsp.last = i + 1 == req.beats;
        beats_.push_back(beat);
      }
      next_ += req.beats * 16;
      asked_ += static_cast<long>(req.beats) / 2;
    }
    if (dut->out_valid_o && take) got.push_back(get_port<prim_slot_t>(dut->out_o));
    dut.tick();
  }

  std::vector<prim_slot_t> run(const Image& image, Stalls stalls = {}, long latency = 60) {
    Gate grant(stalls.source, stalls.burst, 1), respond(stalls.source, stalls.burst, 2), take(stalls.sink, stalls.burst, 3);
    std::vector<prim_slot_t> got;
    start(image);
    dut.settle();
    long cycles = 0;
    for (const long limit = 5000 + 40 * static_cast<long>(slot_count(image.header)); cycles < limit && !dut->done_o; ++cycles) {
      cycle(image, grant.open(), respond.open(), take.open(), latency, got);
      if (HasFatalFailure()) return got;
      dut.settle();
    }
    EXPECT_TRUE(dut->done_o);
    EXPECT_EQ(next_, image.bytes.size()) << "all lines were asked for";
    EXPECT_TRUE(beats_.empty());
    EXPECT_FALSE(dut->out_valid_o);
    cycles_ = cycles;
    return got;
  }
  void expect_model(const Image& image, Stalls stalls = {}, long latency = 60) {
    const auto want = read_slots(image.bytes.data(), image.header), got = run(image, stalls, latency);
    ASSERT_EQ(got.size(), want.size());
    for (std::size_t i = 0; i < got.size(); ++i) ASSERT_TRUE(got[i] == want[i]) << "slot " << i << ": " << to_text(got[i]) << " instead of " << to_text(want[i]);
    EXPECT_EQ(faults_, 0);
  }

  Dut<Vprim_reader> dut;
  std::deque<Beat> beats_;
  std::uint64_t next_ = 0;
  long faults_ = 0, asked_ = 0, cycles_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Stalls, PrimReader, ::testing::ValuesIn(kStallPatterns));

TEST_P(PrimReader, MatchesModel) {
  unsigned seed = 1;
  for (const double empty : {0.0, 0.1, 0.9})
    for (const std::uint64_t lines : {1u, 2u, 3u, 4u, 5u, 7u, 8u, 64u, 300u})
      for (const long latency : {0L, 5L, 60L}) expect_model(random_image(lines, empty, ++seed), GetParam(), latency);
}

TEST_P(PrimReader, ReadsAgainAfterDone) {
  const Image image = random_image(37, 0.2, 99);
  for (int batch = 0; batch < 20; ++batch) expect_model(image, GetParam(), batch % 7);
}

TEST_F(PrimReader, LeavesOutEmptySlots) {
  std::mt19937_64 rng(5);
  const Image half(20, 40, [&](std::uint64_t i) { return slot_of(i % 2 ? NoPrim : i, rng); });
  EXPECT_EQ(run(half).size(), 20u);
  const Image none(50, 0, [&](std::uint64_t) { return slot_of(NoPrim, rng); });
  EXPECT_EQ(run(none).size(), 0u);
  EXPECT_EQ(faults_, 0);
}

TEST_F(PrimReader, OfNoLinesIsDoneAndAsksNothing) {
  const Image image(0, 0, [](std::uint64_t) { return prim_slot_t{}; });
  EXPECT_EQ(run(image).size(), 0u);
  EXPECT_EQ(asked_, 0);
}

TEST_F(PrimReader, ReportsNumbersOutOfRange) {
  std::mt19937_64 rng(6);
  // The largest legal number, the first illegal one, the largest that is not NoPrim.
  struct Case {
    std::uint64_t number, primitives;
    bool legal;
  };
  for (const Case& c : {Case{99, 100, true}, {100, 100, false}, {NoPrim - 1, 100, false}, {NoPrim - 1, NoPrim, true}, {0, 0, false}}) {
    const Image image(3, c.primitives, [&](std::uint64_t i) { return slot_of(i == 3 ? c.number : NoPrim, rng); });
    EXPECT_EQ(run(image).size(), c.legal) << "a wrong number is not passed on";
    EXPECT_EQ(faults_, !c.legal) << c.number;
  }
}

TEST_F(PrimReader, AsksForNoMoreThanItCanHold) {
  const Image image = random_image(100, 0, 7);
  std::vector<prim_slot_t> got;
  start(image);
  for (int i = 0; i < 500; ++i) cycle(image, true, true, false, 3, got);
  EXPECT_EQ(asked_, kDepth);
  EXPECT_TRUE(beats_.empty());
  EXPECT_FALSE(dut->req_valid_o);
  // A burst's places must be free before the next one is asked for.
  for (int i = 0; i < 7; ++i) cycle(image, true, true, true, 3, got);
  EXPECT_EQ(got.size(), 7u);
  for (int i = 0; i < 20; ++i) cycle(image, true, true, false, 3, got);
  EXPECT_EQ(asked_, kDepth);
  cycle(image, true, true, true, 3, got);
  for (int i = 0; i < 20; ++i) cycle(image, true, true, false, 3, got);
  EXPECT_EQ(asked_, kDepth + 8);
  EXPECT_FALSE(dut->done_o);
  const auto want = read_slots(image.bytes.data(), image.header);
  for (int i = 0; i < 2000 && !dut->done_o; ++i) {
    cycle(image, true, true, true, 3, got);
    dut.settle();
  }
  EXPECT_TRUE(got == want);
}

TEST_F(PrimReader, GivesASlotEveryTwoCycles) {
  const Image image = random_image(1000, 0, 8);
  expect_model(image, {}, 1);
  EXPECT_LE(cycles_, 4000 + 20);
}

TEST_F(PrimReader, IsNotDoneBeforeItsFirstStartAndForgetsAtReset) {
  EXPECT_FALSE(dut->done_o);
  const Image image = random_image(60, 0.3, 9);
  for (int at = 1; at < 120; at += 7) {
    std::vector<prim_slot_t> got;
    start(image);
    for (int i = 0; i < at; ++i) cycle(image, true, true, i % 3 == 0, 4, got);
    dut->rsp_valid_i = 0;
    dut.reset();
    EXPECT_FALSE(dut->done_o || dut->req_valid_o || dut->out_valid_o);
    expect_model(image);
  }
}

}  // namespace
}  // namespace castray::tb
