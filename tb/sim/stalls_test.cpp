// SPDX-License-Identifier: Apache-2.0
// Every pattern blocks its channels, a quarter of the time at least, and no other; a seed says how.
#include "axi_bench.hpp"

namespace castray::tb {
namespace {

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

TEST(Stalls, SameSeedSameStalls) {
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

}  // namespace
}  // namespace castray::tb
