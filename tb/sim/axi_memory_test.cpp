// SPDX-License-Identifier: Apache-2.0
// The memory model judged by itself: its timing, its order, its stalls, and that each rule it
// watches over is seen to be broken when it is.
#include <gtest/gtest.h>

#include "sim/axi_manager.hpp"

namespace castray::tb {
namespace {

using sim::AxiManager;
using sim::AxiMemory;
using sim::AxiTiming;
using sim::Stalls;

struct Bench {
  explicit Bench(const AxiTiming& timing = {}, const std::string& pattern = "none", bool may_skip = true, unsigned seed = 7)
      : memory(storage, timing, Stalls(pattern, seed), seed), manager(memory, may_skip) {
    buffer = storage.allocate(65536);
    std::vector<std::uint8_t> bytes(buffer.bytes);
    for (std::size_t i = 0; i < bytes.size(); i += 16) {
      bytes[i] = static_cast<std::uint8_t>(i >> 4);
      bytes[i + 1] = static_cast<std::uint8_t>(i >> 12);
    }
    storage.write(buffer.address, bytes);
    memory.checks().set_windows({{buffer.address, buffer.bytes, true, true}});
  }
  std::uint64_t at(std::uint64_t offset) const { return buffer.address + offset; }
  std::string first_message() { return memory.checks().messages().empty() ? "" : memory.checks().messages()[0]; }

  sim::Storage storage;
  sim::Buffer buffer;
  AxiMemory memory;
  Manager manager;
};

TEST(AxiMemory, FirstBeatComesAfterTheLatencyThenOneACycle) {
  Bench bench;
  bench.manager.run(10);
  bench.manager.read(bench.at(256), 16);
  bench.manager.read(bench.at(1024), 16);
  bench.manager.run(200);
  ASSERT_EQ(bench.manager.beats.size(), 32u);
  for (unsigned i = 0; i < 32; ++i) {
    EXPECT_EQ(bench.manager.beats[i].cycle, bench.manager.accepted_reads[0] + 60 + i);
    EXPECT_EQ(bench.manager.beats[i].word, (i < 16 ? 16u : 48u) + i);
    EXPECT_EQ(bench.manager.beats[i].last, i % 16 == 15);
  }
  EXPECT_EQ(bench.manager.accepted_reads[1], bench.manager.accepted_reads[0] + 1);
  EXPECT_EQ(bench.memory.checks().count(), 0u) << bench.first_message();
  EXPECT_TRUE(bench.memory.idle());
}

TEST(AxiMemory, ResponseComesAfterTheLatency) {
  Bench bench;
  bench.manager.write(bench.at(64), 4, 3, 1000);
  bench.manager.run(100);
  ASSERT_EQ(bench.manager.responses.size(), 1u);
  EXPECT_EQ(bench.manager.responses[0], (WriteResponse{bench.manager.last_beats[0] + 60, 3, sim::kOkay}));
  std::uint32_t words[16];
  bench.storage.read(bench.at(64), {reinterpret_cast<std::uint8_t*>(words), sizeof words});
  for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(words[4 * i], 1000 + i);
  EXPECT_EQ(bench.memory.counters().bytes_written, 64u);
}

TEST(AxiMemory, ReadsAndWritesDoNotSlowEachOther) {
  Bench bench;
  for (int i = 0; i < 8; ++i) bench.manager.read(bench.at(256u * i), 16);
  for (int i = 0; i < 32; ++i) bench.manager.write(bench.at(32768 + 64u * i), 4);
  bench.manager.run(300);
  ASSERT_EQ(bench.manager.beats.size(), 128u);
  EXPECT_EQ(bench.manager.beats.back().cycle, 60u + 127);
  EXPECT_EQ(bench.manager.last_beats.back(), 127u);
}

TEST(AxiMemory, StrobesWriteTheirBytesOnly) {
  Bench bench;
  bench.manager.write(bench.at(0), 1, 0, 0xaabbccdd);
  bench.manager.tick([](AxiManager& m) { m.w.strobes = 0b0110; });
  bench.manager.run(80);
  std::uint8_t bytes[4];
  bench.storage.read(bench.at(0), bytes);
  EXPECT_EQ(bytes[0], 0);
  EXPECT_EQ(bytes[1], 0xcc);
  EXPECT_EQ(bytes[2], 0xbb);
  EXPECT_EQ(bytes[3], 0);
}

TEST(AxiMemory, DataMayComeBeforeItsAddress) {
  Bench bench;
  bench.manager.write(bench.at(0), 4, 1, 5);
  for (int i = 0; i < 6; ++i) bench.manager.tick([](AxiManager& m) { m.aw_valid = false; });
  bench.manager.run(100);
  ASSERT_EQ(bench.manager.responses.size(), 1u);
  EXPECT_EQ(bench.manager.responses[0].cycle, 6u + 60);
  EXPECT_EQ(bench.memory.checks().count(), 0u) << bench.first_message();
}

TEST(AxiMemory, HpTakesEightRequests) {
  Bench bench(AxiTiming::named("hp"));
  for (int i = 0; i < 20; ++i) bench.manager.read(bench.at(16u * i), 1);
  for (int i = 0; i < 20; ++i) bench.manager.write(bench.at(32768 + 16u * i), 1);
  bench.manager.run(500);
  EXPECT_EQ(bench.memory.counters().most_reads, 8u);
  EXPECT_EQ(bench.memory.counters().most_writes, 8u);
  EXPECT_EQ(bench.manager.beats.size(), 20u);
  EXPECT_EQ(bench.manager.responses.size(), 20u);
}

// Sleeping is an optimisation of the host: the same traffic gives the same beats in the same cycles.
TEST(AxiMemory, SleepChangesNothing) {
  std::vector<ReadBeat> beats[2];
  std::vector<WriteResponse> responses[2];
  for (const bool may_skip : {false, true}) {
    Bench bench({}, "none", may_skip);
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
      if (random() % 50 == 0) bench.manager.read(bench.at(random() % 256 * 256), 1 + random() % 16, random() % 4);
      if (random() % 50 == 0) bench.manager.write(bench.at(random() % 256 * 256), 1 + random() % 4, random() % 4);
      bench.manager.set_ready(random() % 4 != 0, random() % 4 != 0);
      bench.manager.tick();
    }
    EXPECT_EQ(bench.manager.skipped > 0, may_skip);
    beats[may_skip] = bench.manager.beats;
    responses[may_skip] = bench.manager.responses;
  }
  EXPECT_EQ(beats[0], beats[1]);
  EXPECT_EQ(responses[0], responses[1]);
}

TEST(AxiMemory, OrderIsKeptWithinAnIdAndNotBetweenIds) {
  Bench bench({.name = "reference", .latency = 60, .outstanding = 64, .reorder = true});
  for (int i = 0; i < 64; ++i) bench.manager.read(bench.at(256u * i), 4, i % 4);
  for (int i = 0; i < 64; ++i) bench.manager.write(bench.at(32768 + 64u * i), 2, i % 4);
  bench.manager.run(1000);
  ASSERT_EQ(bench.manager.beats.size(), 256u);
  ASSERT_EQ(bench.manager.responses.size(), 64u);
  std::array<unsigned, 4> seen{};
  bool interleaved = false;
  for (std::size_t i = 0; i < bench.manager.beats.size(); ++i) {
    const ReadBeat& beat = bench.manager.beats[i];
    const unsigned k = seen[beat.id]++;
    EXPECT_EQ(beat.word, (k / 4 * 4 + beat.id) * 16 + k % 4);
    EXPECT_EQ(beat.last, k % 4 == 3);
    if (i > 0) interleaved |= !bench.manager.beats[i - 1].last && bench.manager.beats[i - 1].id != beat.id;
  }
  EXPECT_TRUE(interleaved);
  EXPECT_GT(bench.memory.counters().reordered, 20u);
}

class AxiStalls : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Patterns, AxiStalls, testing::ValuesIn(Stalls::names()), [](const auto& info) { return info.param; });

TEST_P(AxiStalls, EachBlocksItsChannelsAQuarterOfTheTime) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    Bench bench({}, GetParam(), true, seed);
    for (int i = 0; i < 400; ++i) {
      bench.manager.read(bench.at(i * 64 % 32768), 4);
      bench.manager.write(bench.at(32768 + i * 64 % 32768), 4);
    }
    bench.manager.run(30000);
    EXPECT_EQ(bench.manager.beats.size(), 1600u);
    EXPECT_EQ(bench.manager.responses.size(), 400u);
    EXPECT_EQ(bench.memory.checks().count(), 0u) << bench.first_message();
    EXPECT_TRUE(bench.memory.idle());
    for (unsigned i = 0; i < sim::kChannels; ++i) {
      const sim::StallShare& share = bench.memory.stalls().shares()[i];
      EXPECT_GE(share.wanted, 400u) << sim::kChannelNames[i];
      if (bench.memory.stalls().uses(static_cast<sim::Channel>(i))) {
        EXPECT_GE(share.share(), 0.25) << sim::kChannelNames[i] << ", seed " << seed;
      } else {
        EXPECT_EQ(share.blocked, 0u) << sim::kChannelNames[i];
      }
    }
  }
}

TEST(AxiMemory, SameSeedSameStalls) {
  std::vector<ReadBeat> beats[3];
  for (const unsigned seed : {1u, 1u, 2u}) {
    static int run = 0;
    Bench bench({}, "uniform", true, seed);
    for (int i = 0; i < 50; ++i) bench.manager.read(bench.at(64u * i), 4);
    bench.manager.run(2000);
    beats[run++] = bench.manager.beats;
  }
  EXPECT_EQ(beats[0], beats[1]);
  EXPECT_NE(beats[0], beats[2]);
}

TEST(AxiMemory, FaultsAnswerWithErrors) {
  Bench bench;
  bench.memory.set_faults({{bench.at(512), 32, sim::kSlvErr}, {bench.at(4096), 4096, sim::kDecErr}});
  bench.manager.read(bench.at(480), 6);
  bench.manager.write(bench.at(4096), 1, 0, 0x12345678);
  bench.manager.write(bench.at(8192), 1);
  bench.manager.run(200);
  ASSERT_EQ(bench.manager.beats.size(), 6u);
  for (unsigned i = 0; i < 6; ++i) EXPECT_EQ(bench.manager.beats[i].response, i == 2 || i == 3 ? sim::kSlvErr : sim::kOkay);
  ASSERT_EQ(bench.manager.responses.size(), 2u);
  EXPECT_EQ(bench.manager.responses[0].response, sim::kDecErr);
  EXPECT_EQ(bench.manager.responses[1].response, sim::kOkay);
  std::uint32_t word;
  bench.storage.read(bench.at(4096), {reinterpret_cast<std::uint8_t*>(&word), 4});
  EXPECT_EQ(word, 0x100u) << "a refused write changed the memory";
  EXPECT_EQ(bench.memory.checks().count(), 0u) << "an error response is no fault of the manager";
}

TEST(AxiMemory, ResetDropsWhatIsInFlight) {
  Bench bench;
  bench.manager.read(bench.at(0), 16);
  bench.manager.write(bench.at(0), 4);
  bench.manager.run(65);
  const std::size_t before = bench.manager.beats.size();
  EXPECT_EQ(before, 5u);
  bench.memory.reset({});
  EXPECT_TRUE(bench.memory.idle());
  EXPECT_EQ(bench.memory.counters().dropped, 1u);
  bench.manager.run(100);
  EXPECT_EQ(bench.manager.beats.size(), before);
  bench.manager.read(bench.at(0), 1);
  bench.manager.run(100);
  EXPECT_EQ(bench.manager.beats.size(), before + 1);
}

// Each rule broken once, by a twist of the signals in the first cycle.
struct Twist {
  const char* name;
  const char* message;
  std::function<void(AxiManager&, std::uint64_t base)> break_it;
  unsigned beats = 1;
};
void PrintTo(const Twist& twist, std::ostream* os) { *os << twist.name; }
const Twist kTwists[] = {
    {"CrossesPage", "crosses 4 KiB", [](AxiManager& m, std::uint64_t base) { m.ar.address = base + 4096 - 16; m.ar.length = 1; }},
    {"SeventeenBeats", "more than 16", [](AxiManager& m, std::uint64_t) { m.ar.length = 16; }},
    {"NarrowBeats", "not 16 bytes", [](AxiManager& m, std::uint64_t) { m.ar.size = 3; }},
    {"Wraps", "not an INCR", [](AxiManager& m, std::uint64_t) { m.aw.burst = 2; }},
    {"Unaligned", "not aligned", [](AxiManager& m, std::uint64_t) { m.ar.address += 4; }},
    {"Cache", "AxCACHE", [](AxiManager& m, std::uint64_t) { m.aw.cache = 0; }},
    {"ReadBeforeWindow", "reads outside", [](AxiManager& m, std::uint64_t base) { m.ar.address = base - 16; }},
    {"ReadAfterWindow", "reads outside", [](AxiManager& m, std::uint64_t base) { m.ar.address = base + 65536; }},
    {"WriteAfterWindow", "writes outside", [](AxiManager& m, std::uint64_t base) { m.aw.address = base + 65536; }},
    {"StrobeBeforeStart", "strobe before", [](AxiManager& m, std::uint64_t) { m.aw.address += 4; }},
    {"NoLast", "no WLAST", [](AxiManager& m, std::uint64_t) { m.w.last = false; }},
    {"EarlyLast", "WLAST too early", [](AxiManager& m, std::uint64_t) { m.w.last = true; }, 2},
};
class AxiRules : public testing::TestWithParam<Twist> {};
INSTANTIATE_TEST_SUITE_P(Broken, AxiRules, testing::ValuesIn(kTwists), [](const auto& info) { return std::string(info.param.name); });

TEST_P(AxiRules, IsSeenWhenBroken) {
  Bench bench;
  bench.manager.read(bench.at(0), 1);
  bench.manager.write(bench.at(0), GetParam().beats);
  bench.manager.tick([&](AxiManager& m) { GetParam().break_it(m, bench.at(0)); });
  bench.manager.run(200);
  ASSERT_GE(bench.memory.checks().count(), 1u);
  bool named = false;
  for (const std::string& message : bench.memory.checks().messages()) named |= message.find(GetParam().message) != std::string::npos;
  EXPECT_TRUE(named) << bench.first_message();
}

// With the ready of the channel shut, valid falls or the payload changes.
struct Drop {
  const char* channel;
  std::function<void(AxiManager&)> fall;
  std::function<void(AxiManager&)> change;
};
void PrintTo(const Drop& drop, std::ostream* os) { *os << drop.channel; }
const Drop kDrops[] = {
    {"ar", [](AxiManager& m) { m.ar_valid = false; }, [](AxiManager& m) { m.ar.address += 16; }},
    {"aw", [](AxiManager& m) { m.aw_valid = false; }, [](AxiManager& m) { m.aw.id ^= 1; }},
    {"w", [](AxiManager& m) { m.w_valid = false; }, [](AxiManager& m) { m.w.strobes ^= 1; }},
};
class AxiStable : public testing::TestWithParam<Drop> {};
INSTANTIATE_TEST_SUITE_P(Channels, AxiStable, testing::ValuesIn(kDrops), [](const auto& info) { return std::string(info.param.channel); });

TEST_P(AxiStable, UntakenItemsAreWatched) {
  for (const auto& break_it : {GetParam().fall, GetParam().change}) {
    Bench bench({}, GetParam().channel);
    for (int i = 0; i < 200; ++i) {
      bench.manager.read(bench.at(0), 1);
      bench.manager.write(bench.at(0), 1);
    }
    // Keeping the rules: nothing to report.
    bench.manager.run(100);
    ASSERT_EQ(bench.memory.checks().count(), 0u) << bench.first_message();
    for (int i = 0; i < 100 && bench.memory.checks().count() == 0; ++i) {
      if (bench.memory.checks().watching()) bench.manager.tick(break_it);
      else bench.manager.tick();
    }
    EXPECT_EQ(bench.memory.checks().count(), 1u);
    EXPECT_NE(bench.first_message().find(std::string(GetParam().channel) + ": "), std::string::npos) << bench.first_message();
  }
}

TEST(AxiMemory, ValidInResetIsSeen) {
  Bench bench;
  AxiManager signals;
  bench.memory.reset(signals);
  EXPECT_EQ(bench.memory.checks().count(), 0u);
  signals.aw_valid = true;
  bench.memory.reset(signals);
  EXPECT_EQ(bench.memory.checks().count(), 1u);
}

TEST(Storage, BuffersHaveEdges) {
  sim::Storage storage;
  const sim::Buffer first = storage.allocate(100), second = storage.allocate(100);
  EXPECT_GT(first.address, std::uint64_t{1} << 32);
  EXPECT_NE(storage.find(first.address + 99, 1), nullptr);
  EXPECT_EQ(storage.find(first.address + 99, 2), nullptr);
  EXPECT_EQ(storage.find(first.address - 1, 1), nullptr);
  EXPECT_EQ(storage.find(first.address + 4096, 1), nullptr);
  EXPECT_NE(storage.find(second.address, 100), nullptr);
  storage.release(second);
  EXPECT_EQ(storage.find(second.address, 1), nullptr);
  EXPECT_THROW(storage.write(second.address, std::vector<std::uint8_t>(1)), std::out_of_range);
}

}  // namespace
}  // namespace castray::tb
