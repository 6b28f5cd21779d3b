// SPDX-License-Identifier: Apache-2.0
// The memory model judged by itself: its timing, its order, its errors, its reset.
#include "axi_bench.hpp"

namespace castray::tb {
namespace {

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

}  // namespace
}  // namespace castray::tb
