// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The attribute cache: right data in order whatever is in flight, and hits and misses as a plain
// cache would count them.
#include "mem/attr_tags.hpp"

#include <deque>
#include <optional>

#include "Vattr_cache.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kMisses = DefaultAttrMisses, kQueue = 32, kSets = DefaultAttrEntries / 2;
constexpr std::uint64_t kBase = 0xab'cdef'0100;

std::uint32_t word_of(prim_t number, int at) {
  std::uint32_t x = static_cast<std::uint32_t>(number * 16 + static_cast<unsigned>(at)) * 2654435761u;
  x ^= x >> 15;
  return x * 2246822519u;
}
attr_t attr_of(prim_t number) {
  std::uint32_t words[16];
  for (int i = 0; i < 16; ++i) words[i] = word_of(number, i);
  return unpack<attr_t>(words);
}
hit_t hit_of(prim_t number, std::size_t order) {
  hit_t h;
  h.found = 1;
  h.number = number;
  h.tag.x = order & 4095, h.tag.y = order >> 12;
  h.t = static_cast<t_t>(order * 77);
  return h;
}

struct Latency {
  int least = 20, most = 20;  // cycles from a request to its first beat
  double gap = 0;             // chance that no beat comes in a cycle
};

struct Outcome {
  std::uint64_t hits = 0, misses = 0, requests = 0;
  int most_outstanding = 0;
  long cycles = 0;
};

class AttrCacheUnit : public testing::TestWithParam<Stalls> {
 protected:
  // Sends a hit on each number; every result must be its hit with the line that lies in memory.
  Outcome run(const std::vector<prim_t>& numbers, Latency latency = {}, Stalls stalls = {}) {
    Outcome out;
    Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2), bus(stalls.sink, stalls.burst, 3);
    std::mt19937 rng(4);
    struct Line {
      prim_t number;
      long due;
      int beat = 0;
    };
    std::deque<Line> lines;
    const long start = dut_.cycles(), limit = 4000 + 400L * static_cast<long>(numbers.size());
    std::size_t sent = 0, received = 0;
    bool offering = false;
    std::optional<read_req_t> waiting;
    dut_->base_i = kBase;
    while (received < numbers.size() && dut_.cycles() - start < limit) {
      if (!offering && sent < numbers.size()) offering = source.open();
      dut_->in_valid_i = offering;
      if (offering) set_port(dut_->in_i, hit_of(numbers[sent], sent));
      dut_->out_ready_i = sink.open();
      dut_->req_ready_i = bus.open();
      const bool comes = !lines.empty() && lines.front().due <= dut_.cycles() && (latency.gap == 0 || rng() % 1000 >= latency.gap * 1000);
      dut_->rsp_valid_i = comes;
      if (comes) {
        Line& line = lines.front();
        read_rsp_t rsp;
        for (int i = 0; i < 4; ++i) rsp.data[i] = word_of(line.number, line.beat * 4 + i);
        rsp.last = ++line.beat == 4;
        set_port(dut_->rsp_i, rsp);
        if (rsp.last) lines.pop_front();
      }
      dut_.settle();
      if (dut_->req_valid_o) {
        const auto req = get_port<read_req_t>(dut_->req_o);
        if (waiting) EXPECT_TRUE(req == *waiting) << "an untaken request changed";
        waiting = req;
        if (dut_->req_ready_i) {
          EXPECT_EQ(req.beats, 4u);
          EXPECT_EQ((req.addr - kBase) % 64, 0u);
          const long spread = latency.most - latency.least;
          lines.push_back({(req.addr - kBase) / 64, dut_.cycles() + latency.least + (spread ? static_cast<long>(rng()) % spread : 0)});
          ++out.requests;
          out.most_outstanding = std::max(out.most_outstanding, static_cast<int>(lines.size()));
          waiting.reset();
        }
      } else {
        EXPECT_FALSE(waiting) << "an untaken request was dropped";
        waiting.reset();
      }
      out.hits += dut_->hit_o;
      out.misses += dut_->miss_o;
      if (dut_->out_valid_o && dut_->out_ready_i) {
        const auto got = get_port<shade_req_t>(dut_->out_o);
        EXPECT_EQ(to_text(got.hit), to_text(hit_of(numbers[received], received)));
        EXPECT_TRUE(got.attr == attr_of(numbers[received])) << "item " << received << ", line " << numbers[received];
        ++received;
        if (testing::Test::HasFailure()) break;
      }
      if (offering && dut_->in_ready_o) ++sent, offering = false;
      dut_.tick();
    }
    EXPECT_EQ(received, numbers.size());
    dut_->in_valid_i = dut_->out_ready_i = dut_->req_ready_i = dut_->rsp_valid_i = 0;
    out.cycles = dut_.cycles() - start;
    return out;
  }
  // The same against a plain cache's counts.
  Outcome compare(const std::vector<prim_t>& numbers, Latency latency = {}, Stalls stalls = {}) {
    std::uint64_t hits = 0;
    for (const prim_t n : numbers) hits += tags_.access(n);
    const Outcome out = run(numbers, latency, stalls);
    EXPECT_EQ(out.hits, hits);
    EXPECT_EQ(out.misses, numbers.size() - hits);
    EXPECT_EQ(out.requests, out.misses);
    return out;
  }
  Dut<Vattr_cache> dut_;
  AttrTags tags_;
};

// A walk that stays near, and now and then jumps: as hits along a tile do.
std::vector<prim_t> walk(unsigned seed, int count, unsigned reach, unsigned primitives) {
  std::mt19937 rng(seed);
  std::vector<prim_t> numbers;
  prim_t base = 0;
  for (int i = 0; i < count; ++i) {
    if (rng() % 40 == 0) base = rng() % primitives;
    numbers.push_back((base + rng() % reach) % primitives);
  }
  return numbers;
}

TEST_P(AttrCacheUnit, DeliversAndCountsAsAPlainCache) {
  for (const auto& [reach, primitives] : {std::pair{8u, 6320u}, {200u, 300u}, {2000u, 1u << 20}})
    for (const Latency latency : {Latency{0, 0, 0}, Latency{60, 60, 0}, Latency{1, 150, 0.5}})
      compare(walk(reach, 1500, reach, primitives), latency, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Stalls, AttrCacheUnit, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(AttrCacheUnit, ALineInFlightIsNotAskedForAgain) {
  const Outcome out = compare({7, 7, 7, 8, 7, 8}, {300, 300, 0});
  EXPECT_EQ(out.misses, 2u);
}

TEST_F(AttrCacheUnit, PlacesAreGivenAwayWhileOlderHitsWait) {
  // Three lines of one set in turn: each takes the place of one whose own line is still coming,
  // and whose later hits still wait.
  const prim_t a = 5, b = a + kSets, c = b + kSets;
  const Outcome out = compare({a, a, b, b, c, c, a, b, c, a, a, b, c}, {300, 300, 0});
  EXPECT_EQ(out.misses, 9u);
}

TEST_F(AttrCacheUnit, ReplacesTheWayUsedLongerAgo) {
  const prim_t a = 9, b = a + kSets, c = b + kSets;
  EXPECT_EQ(compare({a, b, a, c, a}).misses, 3u);  // c takes b's way
  EXPECT_EQ(compare({b}).misses, 1u);              // and b c's, for a was used last
  EXPECT_EQ(compare({a, b}).misses, 0u);
}

TEST_F(AttrCacheUnit, ComparesEveryBitOfATag) {
  const prim_t a = 3, b = 3 + (static_cast<prim_t>(NoPrim) & 0x155540);
  for (int bit = 6; bit < PrimW; ++bit)
    for (const bool first : {true, false}) {
      dut_.reset(1);
      tags_ = AttrTags();
      const prim_t other = b ^ (prim_t{1} << bit);
      EXPECT_EQ(compare(first ? std::vector<prim_t>{b, a, other, b} : std::vector<prim_t>{a, b, other, b}).misses, first ? 4u : 3u) << bit;
    }
}

TEST_F(AttrCacheUnit, HoldsEntriesLinesAtOnce) {
  std::vector<prim_t> numbers;
  for (int round = 0; round < 3; ++round)
    for (prim_t n = 0; n < 2 * kSets; ++n) numbers.push_back(1000 + n);
  EXPECT_EQ(compare(numbers).misses, static_cast<std::uint64_t>(2 * kSets));
}

TEST_F(AttrCacheUnit, AsksForSixteenLinesAndNoMore) {
  std::vector<prim_t> numbers;
  for (prim_t n = 0; n < 60; ++n) numbers.push_back(n);
  EXPECT_EQ(compare(numbers, {400, 400, 0}).most_outstanding, kMisses);
}

TEST_F(AttrCacheUnit, ReachesTheLastPrimitive) {
  compare({0, NoPrim - 1, NoPrim - 1 - kSets, 1, NoPrim - 1, 0});
}

TEST_F(AttrCacheUnit, TakesAHitEveryTwoCycles) {
  EXPECT_LE(compare(std::vector<prim_t>(500, 3), {0, 0, 0}).cycles, 2 * 500 + 20);
}

TEST_F(AttrCacheUnit, MissesRunAtTheRateOfTheBus) {
  // Four beats a line; sixteen lines in flight hide 60 cycles.
  std::vector<prim_t> numbers;
  for (prim_t n = 0; n < 300; ++n) numbers.push_back(n);
  EXPECT_LE(compare(numbers, {60, 60, 0}).cycles, 300 * 5 + 100);
}

TEST_F(AttrCacheUnit, FillsTheQueueWhileBlocked) {
  dut_->base_i = kBase;
  dut_->in_valid_i = 1;
  dut_->out_ready_i = 0;
  dut_->req_ready_i = 1;
  dut_->rsp_valid_i = 0;
  set_port(dut_->in_i, hit_of(1, 0));
  int taken = 0;
  for (int i = 0; i < 400; ++i) {
    dut_.settle();
    taken += dut_->in_ready_o;
    dut_.tick();
  }
  EXPECT_EQ(taken, kQueue);  // the first waits for its line, all others behind it
}

TEST_F(AttrCacheUnit, IsEmptyAfterAReset) {
  const std::vector<prim_t> numbers = {1, 2, 3, 1, 2, 3};
  compare(numbers);
  EXPECT_EQ(compare(numbers).misses, 0u);
  dut_.reset(1);
  tags_ = AttrTags();
  EXPECT_EQ(compare(numbers).misses, 3u);
}

}  // namespace
}  // namespace castray::tb
