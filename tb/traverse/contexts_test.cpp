// SPDX-License-Identifier: Apache-2.0
// Contexts given out and back, in either mode, beside sets of numbers.
// Verilator: -GContexts=6
#include <set>

#include "Vcontexts.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 6;

class Contexts : public testing::Test {
 protected:
  void begin(bool hierarchy) {
    dut->hierarchy_i = hierarchy;
    dut->take_i = dut->done_valid_i = dut->out_taken_i = 0;
    dut.reset();
  }
  Dut<Vcontexts> dut;
  std::mt19937 rng{5};
};

TEST_F(Contexts, BruteForceGivesThemOutAndBackFromZeroUp) {
  begin(false);
  for (int rays = 1; rays <= kContexts; ++rays) {
    EXPECT_TRUE(dut->empty_o);
    EXPECT_FALSE(dut->out_valid_o);
    dut->take_i = 1;
    for (int i = 0; i < rays; ++i, dut.tick()) {
      EXPECT_FALSE(dut->full_o);
      EXPECT_EQ(dut->free_ctx_o, i);
    }
    dut->take_i = 0;
    dut.settle();
    EXPECT_EQ(dut->full_o, rays == kContexts);
    dut->out_taken_i = 1;
    for (int i = 0; i < rays; ++i, dut.tick()) {
      EXPECT_EQ(dut->used_o, rays);   // until the last one is out
      EXPECT_TRUE(dut->out_valid_o);
      EXPECT_EQ(dut->out_ctx_o, i);
    }
    dut->out_taken_i = 0;
    dut.settle();
  }
  EXPECT_TRUE(dut->empty_o);
}

// Rays end in any order, two at a time; each context is held by one ray, and each hit leaves once.
TEST_F(Contexts, TheHierarchyUsesWhateverIsFree) {
  begin(true);
  std::set<int> held, running;
  std::set<int> done;
  int full = 0, taken = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    dut.settle();
    ASSERT_EQ(dut->used_o, held.size());
    ASSERT_EQ(dut->full_o, held.size() == kContexts);
    ASSERT_EQ(dut->empty_o, held.empty());
    ASSERT_EQ(dut->out_valid_o, !done.empty());
    const int out = dut->out_ctx_o;
    if (!done.empty()) ASSERT_TRUE(done.count(out)) << "context " << out << " is not done";
    full += dut->full_o;

    const int ctx = dut->free_ctx_o;
    dut->take_i = !dut->full_o && rng() % 3 != 0;
    dut->out_taken_i = !done.empty() && rng() % 2;
    dut->done_valid_i = 0;
    if (dut->out_taken_i) held.erase(out), done.erase(out);
    for (int step = 0; step < 2; ++step) {
      if (running.empty() || rng() % 3 == 0) continue;
      auto it = running.begin();
      std::advance(it, rng() % running.size());
      dut->done_valid_i |= 1 << step;
      dut->done_ctx_i[step] = *it;
      done.insert(*it);
      running.erase(it);
    }
    if (dut->take_i) {
      ASSERT_TRUE(held.insert(ctx).second) << "context " << ctx << " is held by another ray";
      running.insert(ctx);
      ++taken;
    }
    dut.tick();
  }
  EXPECT_GT(full, 1000);
  EXPECT_GT(taken, 5000);
}

TEST_F(Contexts, AreAllGivenOutAndAllComeBack) {
  begin(true);
  for (int round = 0; round < 3; ++round) {
    std::set<int> seen;
    dut->take_i = 1;
    for (int i = 0; i < kContexts; ++i, dut.tick()) seen.insert(dut->free_ctx_o);
    dut->take_i = 0;
    EXPECT_EQ(seen.size(), std::size_t{kContexts});
    EXPECT_LT(*seen.rbegin(), kContexts);
    dut.settle();
    EXPECT_TRUE(dut->full_o);
    dut->done_valid_i = 1;
    for (int i = 0; i < kContexts; ++i, dut.tick()) dut->done_ctx_i[0] = kContexts - 1 - i;
    dut->done_valid_i = 0;
    dut->out_taken_i = 1;
    for (int i = 0; i < kContexts; ++i, dut.tick()) EXPECT_EQ(dut->out_ctx_o, kContexts - 1 - i);
    dut->out_taken_i = 0;
    dut.settle();
    EXPECT_TRUE(dut->empty_o);
  }
}

}  // namespace
}  // namespace castray::tb
