// SPDX-License-Identifier: Apache-2.0
// Each rule that the memory watches over is seen to be broken when it is, and not before.
#include "axi_bench.hpp"

namespace castray::tb {
namespace {

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

TEST(AxiChecks, ValidInResetIsSeen) {
  Bench bench;
  AxiManager signals;
  bench.memory.reset(signals);
  EXPECT_EQ(bench.memory.checks().count(), 0u);
  signals.aw_valid = true;
  bench.memory.reset(signals);
  EXPECT_EQ(bench.memory.checks().count(), 1u);
}

}  // namespace
}  // namespace castray::tb
