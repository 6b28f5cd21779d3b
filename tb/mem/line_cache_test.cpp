// SPDX-License-Identifier: Apache-2.0
// The line cache: each request gets its own line exactly once, whatever waits, comes and is
// replaced meanwhile; a line is asked for once at a time.
#include <map>
#include <optional>

#include "Vline_cache.h"
#include "line_store.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kIds = 1 << CtxW, kMisses = DefaultCacheMisses, kSets = DefaultCacheLines / DefaultCacheWays;

class LineCacheUnit : public testing::TestWithParam<Stalls> {
 protected:
  LineCacheUnit() { idle(); }

  void idle() {
    dut_->in_valid_i = dut_->out_ready_i = dut_->req_ready_i = dut_->fill_valid_i = 0;
    while (!emptied()) dut_.tick();
  }
  bool emptied() {
    dut_.settle();
    return dut_->in_ready_o;
  }

  // One cycle: `line`, if any, is offered under a free number until it is taken.
  void cycle(std::optional<line_no_t> line = {}) {
    if (!offered_ && line && waiting_.size() < kIds) {
      do id_ = rng_() % kIds;
      while (waiting_.contains(id_));
      offered_ = line;
    }
    dut_->in_valid_i = offered_.has_value();
    dut_->in_id_i = offered_ ? id_ : rng_() % kIds;
    dut_->in_line_i = offered_ ? *offered_ : rng_() & ((1u << LineNoW) - 1);
    dut_->out_ready_i = !shut && sink_.open();
    dut_->req_ready_i = asks_.open();
    choose_fill();
    dut_.settle();
    check_out();
    check_req();
    if (filling_ && dut_->fill_ready_o) asked_.erase(*filling_), filling_.reset();
    hits += dut_->hit_o;
    misses += dut_->miss_o;
    taken = offered_ && dut_->in_ready_o;
    if (taken) {
      waiting_[id_] = {*offered_, dut_.cycles()};
      offered_.reset();
    }
    dut_.tick();
  }

  // Offers a line until it is taken.
  void put(line_no_t line) {
    int left = 1000;
    do cycle(line);
    while (!taken && --left != 0);
    ASSERT_TRUE(taken) << "line " << line << " is not taken";
  }

  // Offers all lines and waits for all answers.
  void run(const std::vector<line_no_t>& lines) {
    const long start = dut_.cycles(), limit = 20000 + 400L * static_cast<long>(lines.size());
    const bool fresh = waiting_.empty() && !offered_;
    hits = misses = asked = 0;
    std::size_t sent = offered_ ? -1 : 0;
    while ((sent != lines.size() || !waiting_.empty()) && dut_.cycles() - start < limit && !HasFailure()) {
      cycle(sent < lines.size() && source_.open() ? std::optional(lines[sent]) : std::nullopt);
      sent += taken;
    }
    EXPECT_EQ(sent, lines.size());
    EXPECT_TRUE(waiting_.empty()) << waiting_.size() << " were not answered";
    EXPECT_TRUE(asked_.empty());
    if (fresh) EXPECT_EQ(hits + misses, static_cast<long>(lines.size()));
    cycles = dut_.cycles() - start;
  }

  void stall(Stalls stalls) {
    source_ = Gate(stalls.source, stalls.burst, 1), sink_ = Gate(stalls.sink, stalls.burst, 2);
    asks_ = Gate(stalls.sink, stalls.burst, 3), fills_ = Gate(stalls.source, stalls.burst, 4);
  }

  // The line that memory gives in this cycle; an offered one is kept.
  void choose_fill() {
    if (!filling_ && fills_.open()) {
      std::vector<unsigned> due;
      for (const auto& [miss, asked] : asked_)
        if (asked.due <= dut_.cycles()) due.push_back(miss);
      if (!due.empty()) filling_ = due[rng_() % due.size()];
    }
    line_data_t data{};
    const unsigned miss = filling_ ? *filling_ : rng_() % (1 << MissW);
    if (filling_) data = data_of(asked_[miss].line);
    dut_->fill_valid_i = dut_->data_valid_i = filling_.has_value();
    dut_->fill_miss_i = dut_->data_miss_i = miss;
    for (unsigned w = 0; w < data.size(); ++w) dut_->data_i[w] = data[w];
  }

  void check_out() {
    const unsigned id = dut_->out_id_o;
    if (held_id_) EXPECT_TRUE(dut_->out_valid_o && id == *held_id_) << "an untaken line was dropped or changed";
    held_id_.reset();
    if (!dut_->out_valid_o) return;
    const auto it = waiting_.find(id);
    if (it == waiting_.end()) {
      ADD_FAILURE() << "number " << id << " did not ask";
      return;
    }
    EXPECT_EQ(line_at(dut_->out_data_o), data_of(it->second.line)) << "line " << it->second.line;
    if (!dut_->out_ready_i) {
      held_id_ = id;
      return;
    }
    longest = std::max(longest, dut_.cycles() - it->second.since);
    order.push_back(it->second.line);
    waiting_.erase(it);
  }

  void check_req() {
    if (!dut_->req_valid_o) {
      EXPECT_FALSE(held_req_) << "an untaken request was dropped";
      return;
    }
    const auto req = get_port<line_req_t>(dut_->req_o);
    if (held_req_) EXPECT_TRUE(req == *held_req_) << "an untaken request changed";
    held_req_ = req;
    if (!dut_->req_ready_i) return;
    held_req_.reset();
    EXPECT_FALSE(asked_.contains(req.miss)) << "number " << req.miss << " is in use";
    for (const auto& [miss, asked] : asked_) EXPECT_NE(asked.line, req.line) << "a line in flight is asked for again";
    asked_[req.miss] = {req.line, dut_.cycles() + latency.draw(rng_)};
    ++asked;
    most_asked = std::max(most_asked, asked_.size());
  }

  struct Waiting {
    line_no_t line;
    long since;
  };
  struct Asked {
    line_no_t line;
    long due;
  };
  Dut<Vline_cache> dut_;
  std::mt19937 rng_{7};
  Gate source_{0, 1, 1}, sink_{0, 1, 2}, asks_{0, 1, 3}, fills_{0, 1, 4};
  std::map<unsigned, Waiting> waiting_;  // by the number of who asked
  std::map<unsigned, Asked> asked_;      // by the number of the miss
  std::optional<unsigned> filling_, held_id_;
  std::optional<line_req_t> held_req_;
  std::optional<line_no_t> offered_;
  unsigned id_ = 0;

  Latency latency;
  bool shut = false;                     // nothing is taken from out
  bool taken = false;                    // the line offered in the last cycle
  long hits = 0, misses = 0, asked = 0, cycles = 0, longest = 0;
  std::size_t most_asked = 0;
  std::vector<line_no_t> order;          // lines as they were given
};

std::vector<line_no_t> random_lines(unsigned seed, int count, unsigned sets, unsigned tags) {
  std::mt19937 rng(seed);
  std::vector<line_no_t> lines;
  for (int i = 0; i < count; ++i) lines.push_back(rng() % sets + kSets * (rng() % tags));
  return lines;
}

TEST_P(LineCacheUnit, GivesEachItsLine) {
  stall(GetParam());
  for (const auto& [sets, tags] : {std::pair{1u, 3u}, {2u, 40u}, {8u, 2u}, {64u, 8u}, {256u, 3u}, {256u, 1u << 18}})
    for (const Latency l : {Latency{0, 0}, Latency{60, 60}, Latency{1, 150}}) {
      latency = l;
      run(random_lines(sets * tags, 1500, sets, tags));
    }
  EXPECT_LE(longest, 2500) << "of 64 at once, through 16 misses of 150 cycles at most";
}
INSTANTIATE_TEST_SUITE_P(Stalls, LineCacheUnit, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(LineCacheUnit, AHitTakesFourCycles) {
  run({5});
  longest = 0;
  run({5});
  EXPECT_EQ(hits, 1);
  EXPECT_EQ(longest, 4);
}

TEST_F(LineCacheUnit, AMissTakesSevenCyclesBesidesTheMemorys) {
  latency = {40, 40};
  run({5});
  EXPECT_EQ(longest, 3 + 40 + 4) << "until the line is asked for, until it comes, until it is given";
}

TEST_F(LineCacheUnit, LooksUpALineEachCycle) {
  run({5, 6, 7});
  run(std::vector<line_no_t>(900, 6));
  EXPECT_EQ(hits, 900);
  EXPECT_LE(cycles, 900 + 5);
}

TEST_F(LineCacheUnit, HitsPassMisses) {
  run({5});
  order.clear();
  latency = {300, 300};
  run({1000, 1001, 5, 1000, 5});
  EXPECT_EQ(order[0], 5u);
  EXPECT_EQ(order[1], 5u);
  EXPECT_EQ(asked, 2);
}

TEST_F(LineCacheUnit, AllWaitForOneLine) {
  latency = {200, 200};
  run(std::vector<line_no_t>(kIds, 77));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(misses, long{kIds});
  EXPECT_LE(cycles, 3 + 200 + 4 + long{kIds}) << "one each cycle once the line is there";
}

TEST_F(LineCacheUnit, JoinsALineAskedForTheCycleBefore) {
  latency = {30, 30};
  run({9, 9, 8, 9, 8, 8});
  EXPECT_EQ(asked, 2);
}

TEST_F(LineCacheUnit, AsksForSixteenLinesAndNoMore) {
  std::vector<line_no_t> lines;
  for (line_no_t n = 0; n < 60; ++n) lines.push_back(n);
  latency = {400, 400};
  run(lines);
  EXPECT_EQ(most_asked, kMisses);
  EXPECT_LE(cycles, 4 * 440);
}

TEST_F(LineCacheUnit, TakesNothingWhileAllMissesAreInUse) {
  run({3});
  latency = {100000, 100000};
  line_no_t next = 1000;
  for (int i = 0; i < 100; ++i) {
    cycle(next);
    next += taken;
  }
  EXPECT_EQ(waiting_.size(), kMisses);
  EXPECT_EQ(asked_.size(), kMisses);
  asked_[11].due = 0;  // one line comes: one more request
  for (int i = 0; i < 100; ++i) {
    cycle(next);
    next += taken;
  }
  EXPECT_EQ(waiting_.size(), kMisses);
  EXPECT_EQ(next, 1000 + kMisses + 1);
  for (auto& [miss, asked] : asked_) asked.due = 0;
  latency = {};
  run({3});
}

TEST_F(LineCacheUnit, WaitsForAsManyLinesOfASetAsItHasWays) {
  for (const bool backwards : {false, true}) {
    latency = {100000, 100000};
    for (line_no_t tag = 1; tag <= DefaultCacheWays; ++tag)
      for (int i = 0; i < 4; ++i)
        put(kSets * tag + 9);
    for (int i = 0; i < 30; ++i) cycle(kSets * (DefaultCacheWays + 1) + 9);
    EXPECT_EQ(asked_.size(), DefaultCacheWays) << "the next has no way to take";
    EXPECT_EQ(waiting_.size(), 4 * DefaultCacheWays + 2) << "one compared, one looked up";
    for (auto& [miss, asked] : asked_) asked.due = dut_.cycles() + 20 * static_cast<long>(backwards ? 2 - miss : miss);
    latency = {20, 20};
    run({});
    dut_.reset(1);
    idle();
  }
}

TEST_F(LineCacheUnit, ALineStaysUntilAllHaveIt) {
  // Three lines of a set of two ways come while nothing is taken: none replaces one that is waited for.
  shut = true;
  latency = {30, 30};
  for (const line_no_t tag : {1, 2})
    for (int i = 0; i < 12; ++i)
      put(kSets * tag + 200);
  for (int i = 0; i < 200; ++i) cycle(kSets * 3 + 200);
  EXPECT_TRUE(asked_.empty()) << "the third is not asked for before the first two were given";
  EXPECT_EQ(waiting_.size(), 24u + 2u);
  shut = false;
  run({});
}

TEST_F(LineCacheUnit, IsAskedForALineWhileItComes) {
  // A request at each distance from the line's arrival, among others of the same set.
  for (int at = 0; at < 60; ++at) {
    const line_no_t line = kSets * (100u + at) + 7;
    latency = {20, 20};
    cycle(line);
    for (int i = 0; i < at; ++i) cycle();
    for (int i = 0; i < 4; ++i) cycle(i == 1 ? line + kSets * 64 : line);
    run({});
  }
}

TEST_F(LineCacheUnit, ReplacesTheWayUsedLongerAgo) {
  const line_no_t a = 9, b = a + kSets, c = b + kSets;
  for (const line_no_t line : {a, b, a, c}) run({line});
  run({a});
  EXPECT_EQ(hits, 1) << "c has b's place";
  run({b});
  EXPECT_EQ(misses, 1);
  run({a});
  EXPECT_EQ(hits, 1) << "b has c's place";
}

TEST_F(LineCacheUnit, ComparesEveryBitOfATag) {
  const line_no_t b = 3 + (0x2aaaau << 8);
  for (int bit = 8; bit < LineNoW; ++bit)
    for (const bool first : {true, false}) {
      dut_.reset(1);
      idle();
      const line_no_t other = b ^ (line_no_t{1} << bit);
      for (const line_no_t line : first ? std::vector<line_no_t>{b, 3} : std::vector<line_no_t>{3, b}) run({line});
      run({other});
      EXPECT_EQ(misses, 1) << "bit " << bit;
    }
}

TEST_F(LineCacheUnit, ComparesEveryBitOfALineInFlight) {
  const line_no_t line = 0x2aaaaaa & ((1u << LineNoW) - 1);
  latency = {100, 100};
  for (int bit = 0; bit < LineNoW; ++bit) {
    const line_no_t other = line ^ (line_no_t{1} << bit);
    run({line, other});  // compared with the one before
    dut_.reset(1);
    idle();
    run({line, 5, 6, other});  // and with those asked for earlier
    dut_.reset(1);
    idle();
  }
}

TEST_F(LineCacheUnit, HoldsAllItsLines) {
  std::vector<line_no_t> lines;
  for (line_no_t n = 0; n < 2 * kSets; ++n) lines.push_back(12345 + n);
  run(lines);
  run(lines);
  EXPECT_EQ(misses, 0);
}

TEST_F(LineCacheUnit, HoldsFourLinesWhileBlocked) {
  run({5});
  shut = true;
  for (int i = 0; i < 30; ++i) cycle(5);
  EXPECT_EQ(waiting_.size(), 4u) << "looked up, compared, read, and in the output register";
  shut = false;
  run({});
}

TEST_F(LineCacheUnit, TakesNothingUntilItsTagsAreEmptied) {
  dut_.reset(1);
  const long start = dut_.cycles();
  idle();
  EXPECT_EQ(dut_.cycles() - start, long{kSets});
}

TEST_F(LineCacheUnit, IsEmptyAfterAReset) {
  const std::vector<line_no_t> lines = random_lines(3, 40, 256, 2);
  run(lines);
  run(lines);
  EXPECT_EQ(misses, 0);
  dut_.reset(1);
  idle();
  run(lines);
  EXPECT_GE(misses, 35);
}

TEST_F(LineCacheUnit, IsUsableAfterAResetInMidFlight) {
  for (int cut = 1; cut < 120; cut += 3) {
    latency = {10, 50};
    for (int i = 0; i < cut; ++i) cycle(rng_() % 6 * kSets + 3);
    dut_->in_valid_i = dut_->fill_valid_i = 0;
    dut_.reset(1);
    waiting_.clear(), asked_.clear(), offered_.reset(), filling_.reset(), held_id_.reset(), held_req_.reset();
    idle();
    run(random_lines(cut, 60, 2, 4));
  }
}

}  // namespace
}  // namespace castray::tb
