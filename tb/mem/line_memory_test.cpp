// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The memory behind the caches: each client gets each line that it asked for once, under its own
// number; a line is fetched once at a time, from its own port.
#include <map>
#include <optional>
#include <set>

#include "Vline_memory.h"
#include "line_store.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kClients = 3, kMisses = DefaultL2Misses, kClientMisses = DefaultCacheMisses;
constexpr std::uint64_t kBase = 0xab'cdef'0100;

// A variant of line_memory_tb.
struct Variant {
  const char* name;
  unsigned select, ports, lines;
};
const Variant kVariants[] = {
    {"one_port_bare", 0, 1, 32}, {"two_ports_bare", 1, 2, 64}, {"one_port_cached", 2, 1, 2048}, {"two_ports_cached", 3, 2, 2048}};
const Variant& kOne = kVariants[2];
const Variant& kTwo = kVariants[3];
void PrintTo(const Variant& variant, std::ostream* os) { *os << variant.name; }

// A port: requests in order, an answer of four beats for each, gaps between them.
struct Port {
  struct Burst {
    line_no_t line;
    long due;
    int beat = 0;
  };
  std::deque<Burst> bursts;
  std::set<line_no_t> lines;  // in flight
  std::optional<read_req_t> held;
  long fetched = 0;
  std::size_t most = 0;
  long last_beat = 0;         // the cycle in which the last one came
};

class LineMemory {
 public:
  explicit LineMemory(const Variant& variant) : variant_(variant) {
    dut_->select_i = variant.select;
    dut_->base_i = kBase;
    reset();
  }

  void reset() {
    dut_->req_valid_i = dut_->rsp_valid_i = 0;
    dut_.reset(1);
    for (unsigned c = 0; c < kClients; ++c) wanted[c].clear(), waiting_[c].clear(), offered_[c].reset();
    for (Port& port : ports) port.bursts.clear(), port.lines.clear(), port.held.reset();
    held_.reset();
    for (int i = 0; i < 600; ++i) cycle();  // the tags are emptied
  }

  void stall(Stalls stalls) {
    for (unsigned c = 0; c < kClients; ++c) {
      source_[c] = Gate(stalls.source, stalls.burst, 10 + c);
      sink_[c] = Gate(stalls.sink, stalls.burst, 20 + c);
    }
    for (unsigned p = 0; p < 2; ++p) {
      asks_[p] = Gate(stalls.sink, stalls.burst, 30 + p);
      beats_[p] = Gate(stalls.source, stalls.burst, 40 + p);
    }
  }

  void cycle() {
    drive_clients();
    drive_ports();
    dut_.settle();
    check_fill();
    for (unsigned p = 0; p < 2; ++p) check_read(p);
    for (unsigned c = 0; c < kClients; ++c) {
      if (!offered_[c] || !(dut_->req_ready_o >> c & 1)) continue;
      waiting_[c][offered_[c]->miss] = {offered_[c]->line, dut_.cycles()};
      taken.push_back(c);
      offered_[c].reset();
      wanted[c].pop_front();
    }
    hits += __builtin_popcount(dut_->hit_o);
    misses += __builtin_popcount(dut_->miss_o);
    dut_.tick();
  }

  // Until all that is wanted was given.
  void run() {
    const long start = dut_.cycles();
    std::size_t count = 0;
    for (const auto& lines : wanted) count += lines.size();
    const long limit = 4000 + 400L * static_cast<long>(count);
    hits = misses = 0, longest = 0;
    for (Port& port : ports) port.fetched = 0;
    while (!finished() && dut_.cycles() - start < limit && !testing::Test::HasFailure()) cycle();
    EXPECT_TRUE(finished()) << "lines are missing";
    EXPECT_EQ(hits + misses, static_cast<long>(count));
    cycles = dut_.cycles() - start;
  }
  long fetched() const { return ports[0].fetched + ports[1].fetched; }

  std::deque<line_no_t> wanted[kClients];
  Port ports[2];
  std::vector<unsigned> taken;  // clients, in turn
  Latency latency;
  bool shut = false;            // no client takes a line
  long hits = 0, misses = 0, cycles = 0, longest = 0, asked_at = 0, given_at = 0;
  std::mt19937 rng{11};

 private:
  struct Waiting {
    line_no_t line;
    long since;
  };

  void drive_clients() {
    dut_->req_valid_i = dut_->fill_ready_i = 0;
    for (unsigned c = 0; c < kClients; ++c) {
      if (!offered_[c] && !wanted[c].empty() && waiting_[c].size() < kClientMisses && source_[c].open()) {
        line_req_t req;
        do req.miss = rng() % kClientMisses;
        while (waiting_[c].contains(req.miss));
        req.line = wanted[c].front();
        offered_[c] = req;
        asked_at = dut_.cycles();
      }
      line_req_t junk;
      junk.line = rng() % 64;
      dut_->req_valid_i |= unsigned{offered_[c].has_value()} << c;
      set_port(dut_->req_i[c], offered_[c].value_or(junk));
      dut_->fill_ready_i |= unsigned{!shut && sink_[c].open()} << c;
    }
  }

  void drive_ports() {
    dut_->read_ready_i = dut_->rsp_valid_i = 0;
    for (unsigned p = 0; p < 2; ++p) {
      Port& port = ports[p];
      dut_->read_ready_i |= unsigned{asks_[p].open()} << p;
      read_rsp_t rsp;
      rsp.last = rng() & 1;
      for (auto& word : rsp.data) word = static_cast<std::uint32_t>(rng());
      if (!port.bursts.empty() && port.bursts.front().due <= dut_.cycles() && beats_[p].open()) {
        Port::Burst& burst = port.bursts.front();
        const line_data_t data = data_of(burst.line);
        std::copy_n(data.begin() + 4 * burst.beat, 4, rsp.data.begin());
        rsp.last = ++burst.beat == 4;
        dut_->rsp_valid_i |= 1u << p;
        if (rsp.last) {
          port.lines.erase(burst.line);
          port.bursts.pop_front();
          port.last_beat = dut_.cycles();
        }
      }
      set_port(dut_->rsp_i[p], rsp);
    }
  }

  void check_read(unsigned p) {
    Port& port = ports[p];
    const bool valid = dut_->read_valid_o >> p & 1;
    if (port.held) EXPECT_TRUE(valid) << "an untaken request was dropped";
    if (!valid) return;
    const auto req = get_port<read_req_t>(dut_->read_o[p]);
    if (port.held) EXPECT_TRUE(req == *port.held) << "an untaken request changed";
    port.held = req;
    if (!(dut_->read_ready_i >> p & 1)) return;
    port.held.reset();
    const line_no_t line = (req.addr - kBase) / 64;
    EXPECT_EQ(req.beats, 4u);
    EXPECT_EQ((req.addr - kBase) % 64, 0u);
    EXPECT_TRUE(req.addr >= kBase && line < (1u << LineNoW));
    if (variant_.ports == 2) EXPECT_EQ(line % 2, p) << "a line of the other port";
    EXPECT_TRUE(port.lines.insert(line).second) << "a line in flight is asked for again";
    const long after = port.bursts.empty() ? 0 : port.bursts.back().due;
    port.bursts.push_back({line, std::max(after, dut_.cycles() + latency.draw(rng))});
    port.most = std::max(port.most, port.bursts.size());
    ++port.fetched;
  }

  void check_fill() {
    if (held_) EXPECT_EQ(dut_->fill_valid_o, held_valid_) << "an untaken line went elsewhere";
    if (!dut_->fill_valid_o) return;
    if (__builtin_popcount(dut_->fill_valid_o) != 1) ADD_FAILURE() << "a line for two clients";
    const auto fill = get_port<line_fill_t>(dut_->fill_o);
    if (held_) EXPECT_TRUE(fill == *held_) << "an untaken line changed";
    else given_at = dut_.cycles();
    held_ = fill;
    held_valid_ = dut_->fill_valid_o;
    if (!(dut_->fill_valid_o & dut_->fill_ready_i)) return;
    held_.reset();
    auto& waiting = waiting_[__builtin_ctz(dut_->fill_valid_o)];
    const auto it = waiting.find(static_cast<unsigned>(fill.miss));
    if (it == waiting.end()) {
      ADD_FAILURE() << "nobody waits under number " << fill.miss;
      return;
    }
    EXPECT_EQ(fill.data, data_of(it->second.line)) << "line " << it->second.line;
    longest = std::max(longest, dut_.cycles() - it->second.since);
    waiting.erase(it);
  }

  bool finished() const {
    for (unsigned c = 0; c < kClients; ++c)
      if (!wanted[c].empty() || !waiting_[c].empty()) return false;
    return true;
  }

  Variant variant_;
  Dut<Vline_memory> dut_;
  std::map<unsigned, Waiting> waiting_[kClients];  // by the number of the miss
  std::optional<line_req_t> offered_[kClients];
  std::optional<line_fill_t> held_;
  unsigned held_valid_ = 0;
  std::vector<Gate> source_ = std::vector(kClients, Gate(0, 1, 1)), sink_ = source_, asks_ = source_, beats_ = source_;
};

class LineMemoryUnit : public testing::TestWithParam<std::tuple<Variant, Stalls>> {};
class LineMemoryVariant : public testing::TestWithParam<Variant> {};

TEST_P(LineMemoryUnit, GivesEachClientItsLines) {
  const auto& [variant, stalls] = GetParam();
  LineMemory memory(variant);
  memory.stall(stalls);
  for (const unsigned range : {4u, 100u, 3000u, 1u << LineNoW})
    for (const Latency latency : {Latency{0, 0}, Latency{60, 60}, Latency{1, 150}}) {
      memory.latency = latency;
      for (auto& wanted : memory.wanted)
        for (int i = 0; i < 200; ++i) wanted.push_back(memory.rng() % range);
      memory.run();
      EXPECT_LE(memory.longest, 8000) << "48 at once, each behind all others on its port";
      for (const Port& port : memory.ports) EXPECT_LE(port.most, kMisses);
    }
}
INSTANTIATE_TEST_SUITE_P(Variants, LineMemoryUnit, testing::Combine(testing::ValuesIn(kVariants), testing::ValuesIn(kStallPatterns)),
                         [](const auto& info) { return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name; });

TEST_P(LineMemoryVariant, FetchesALineThatAllWantOnce) {
  LineMemory memory(GetParam());
  memory.latency = {100, 100};
  for (auto& wanted : memory.wanted)
    for (const line_no_t line : {77, 78, 77, 78, 79}) wanted.push_back(line);
  memory.run();
  EXPECT_EQ(memory.fetched(), 3);
}

TEST_P(LineMemoryVariant, HasTwentyFourLinesUnderWayForEachPort) {
  LineMemory memory(GetParam());
  memory.latency = {3000, 3000};
  for (unsigned c = 0; c < kClients; ++c)
    for (line_no_t i = 0; i < 60; ++i) memory.wanted[c].push_back(1000 * c + 2 * i + (i / 4) % 2);
  for (int i = 0; i < 500; ++i) memory.cycle();
  for (unsigned p = 0; p < GetParam().ports; ++p) EXPECT_EQ(memory.ports[p].bursts.size(), kMisses);
}

TEST_P(LineMemoryVariant, KeepsThePortsBusy) {
  LineMemory memory(GetParam());
  memory.latency = {60, 60};
  for (unsigned c = 0; c < kClients; ++c)
    for (line_no_t i = 0; i < 600; ++i) memory.wanted[c].push_back(100000 * c + i);
  memory.run();
  EXPECT_EQ(memory.fetched(), 1800);
  // A line takes a port four cycles.
  EXPECT_LE(memory.cycles, 1800 * 4 / GetParam().ports * 102 / 100 + 100);
}

TEST_P(LineMemoryVariant, ServesClientsInTurn) {
  LineMemory memory(GetParam());
  for (auto& wanted : memory.wanted)
    for (line_no_t i = 0; i < 200; ++i) wanted.push_back(2 * (i % 8));
  memory.run();
  memory.taken.clear();
  for (auto& wanted : memory.wanted)
    for (line_no_t i = 0; i < 200; ++i) wanted.push_back(2 * (i % 8));
  for (int i = 0; i < 60; ++i) memory.cycle();
  std::array<int, kClients> count{};
  for (std::size_t i = 0; i < 30; ++i) ++count.at(memory.taken.at(i));
  EXPECT_EQ(count, (std::array{10, 10, 10}));
}

TEST_P(LineMemoryVariant, LosesNothingWhileNoClientTakesALine) {
  LineMemory memory(GetParam());
  memory.shut = true;
  for (unsigned c = 0; c < kClients; ++c)
    for (line_no_t i = 0; i < 60; ++i) memory.wanted[c].push_back(1000 * c + i);
  for (int i = 0; i < 1000; ++i) memory.cycle();
  memory.shut = false;
  memory.hits = memory.misses = 0;
  for (int i = 0; i < 4000; ++i) memory.cycle();
  EXPECT_EQ(memory.fetched(), 180);
}

TEST_P(LineMemoryVariant, ReachesTheLastLine) {
  LineMemory memory(GetParam());
  const line_no_t last = (1u << LineNoW) - 1;
  for (auto& wanted : memory.wanted) wanted = {0, last, last - 1, last - 4096, 1, last};
  memory.run();
}

TEST_P(LineMemoryVariant, IsUsableAfterAReset) {
  LineMemory memory(GetParam());
  for (int cut = 1; cut < 160; cut += 13) {
    for (auto& wanted : memory.wanted)
      for (int i = 0; i < 60; ++i) wanted.push_back(memory.rng() % 40);
    for (int i = 0; i < cut; ++i) memory.cycle();
    memory.reset();
    for (auto& wanted : memory.wanted)
      for (int i = 0; i < 60; ++i) wanted.push_back(memory.rng() % 40);
    memory.run();
  }
}
INSTANTIATE_TEST_SUITE_P(Variants, LineMemoryVariant, testing::ValuesIn(kVariants),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(LineMemoryUnit, HoldsTheLinesOfTheSecondCache) {
  for (const Variant& variant : {kOne, kTwo}) {
    LineMemory memory(variant);
    for (int round = 0; round < 2; ++round) {
      for (line_no_t i = 0; i < variant.lines; ++i) memory.wanted[i % kClients].push_back(5000 + i);
      memory.run();
      EXPECT_EQ(memory.hits, round == 0 ? 0 : long{variant.lines}) << variant.name;
    }
  }
}

TEST(LineMemoryUnit, ReplacesTheWayThatTheTreePointsTo) {
  // Four lines take the ways 0, 2, 1, 3; the use of way 1 turns the root to the upper two, of which 3 came last.
  LineMemory memory(kTwo);
  const line_no_t a = 6, step = 512, b = a + step, c = b + step, d = c + step, e = d + step;
  for (const line_no_t line : {a, b, c, d, c, e}) {
    memory.wanted[0] = {line};
    memory.run();
  }
  for (const line_no_t line : {a, c, d, e, b}) {
    memory.wanted[0] = {line};
    memory.run();
    EXPECT_EQ(memory.hits, line != b) << "line " << line;
  }
}

TEST(LineMemoryUnit, AHitTakesFiveCycles) {
  LineMemory memory(kTwo);
  for (int round = 0; round < 2; ++round) {
    memory.wanted[1] = {7};
    memory.run();
  }
  EXPECT_EQ(memory.given_at - memory.asked_at, 5);
}

TEST(LineMemoryUnit, AMissTakesNineCyclesBesidesTheMemorys) {
  LineMemory memory(kTwo);
  memory.latency = {60, 60};
  memory.wanted[2] = {7};
  memory.run();
  EXPECT_EQ(memory.ports[1].last_beat - memory.asked_at, 4 + 60 + 3) << "until the last beat";
  EXPECT_EQ(memory.given_at - memory.ports[1].last_beat, 5) << "until the line is given";
}

}  // namespace
}  // namespace castray::tb
