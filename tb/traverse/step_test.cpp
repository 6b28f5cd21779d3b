// SPDX-License-Identifier: Apache-2.0
// Where a context goes next: random trees beside the model; order, drops, limits, rates by name.
// Verilator: -GContexts=6 -GStackDepth=4
#include "step_world.hpp"

namespace castray::tb {
namespace {

TEST(Step, MatchesModelOnRandomTrees) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Shape shape;
    shape.children = seed % 2 ? 4 : 2;
    shape.delay = seed % 4 * 0.3;
    shape.limit = seed % 3 ? 1000 : 6;
    StepWorld world(shape, seed);
    world.run(3000);
    EXPECT_GT(world.visits, 6000);
    EXPECT_GT(world.drops, 250);
    EXPECT_GT(world.errors[ErrStack], 0);
    if (seed % 3 == 0) EXPECT_GT(world.errors[ErrSteps], 10);
  }
}

class StepUnit : public testing::Test {
 protected:
  StepUnit() {
    dut->limit_i = 1000;
    dut->reach_i = 4095;
    dut->stop_i = dut->start_valid_i = dut->node_valid_i = dut->leaf_valid_i = 0;
  }
  static entry_t entry(std::uint64_t kind, line_t index, dist_t dist = 0) {
    entry_t e;
    e.least = dist, e.target.kind = kind, e.target.index = index;
    return e;
  }
  static visits_t nodes(std::vector<entry_t> entries) {
    visits_t v;
    entry_t* const places[] = {&v.e0, &v.e1, &v.e2, &v.e3};
    for (std::size_t i = 0; i < entries.size(); ++i) *places[i] = entries[i];
    return v;
  }
  // An input for one cycle; the decision on it is at the outputs afterwards. What a context was sent
  // to is back at the earliest when its decision is over: two cycles pass first.
  void start(int ctx, const ref_t& first, const ref_t& second = {}) {
    start_t s;
    s.first = first, s.second = second;
    dut->start_valid_i = 1, dut->start_ctx_i = ctx;
    set_port(dut->start_i, s);
    dut.settle();
    ASSERT_TRUE(dut->start_ready_o);
    dut.tick();
    dut->start_valid_i = 0;
    dut.settle();
  }
  void children(int ctx, const visits_t& visits, bool pause = true) {
    if (pause) dut.tick(), dut.tick();
    dut->node_valid_i = 1, dut->node_ctx_i = ctx;
    set_port(dut->node_i, visits);
    dut.tick();
    dut->node_valid_i = 0;
    dut.settle();
  }
  void leaf_over(int ctx) {
    dut.tick(), dut.tick();
    dut->leaf_valid_i = 1, dut->leaf_ctx_i = ctx;
    dut.tick();
    dut->leaf_valid_i = 0;
    dut.settle();
  }
  void expect_visit(int ctx, line_t index) {
    EXPECT_TRUE(dut->node_valid_o || dut->leaf_valid_o);
    EXPECT_EQ(dut->out_ctx_o, ctx);
    EXPECT_EQ(get_port<ref_t>(dut->out_ref_o).index, index);
    EXPECT_EQ(dut->fault_o, ErrNone);
  }
  void expect_done(int ctx) {
    EXPECT_TRUE(dut->done_valid_o);
    EXPECT_EQ(dut->out_ctx_o, ctx);
  }
  void expect_fault(error_t error) {
    EXPECT_FALSE(dut->node_valid_o || dut->leaf_valid_o || dut->done_valid_o);
    dut.tick();
    EXPECT_EQ(dut->fault_o, error);
  }
  Dut<Vstep> dut;
};

TEST_F(StepUnit, GoesToTheNearestAndComesBackToTheOthersInOrder) {
  start(2, entry(RefNode, 9).target);
  expect_visit(2, 9);
  children(2, nodes({entry(RefNode, 10, 5), entry(RefLeaf, 11, 6), entry(RefNode, 12, 7), entry(RefLeaf, 13, 8)}));
  expect_visit(2, 10);
  children(2, nodes({entry(RefLeaf, 20, 1), entry(RefLeaf, 21, 2)}));  // the deeper frame comes first
  expect_visit(2, 20);
  for (const line_t index : {21, 11}) {
    leaf_over(2);
    expect_visit(2, index);
    EXPECT_TRUE(dut->leaf_valid_o);
  }
  leaf_over(2);
  expect_visit(2, 12);
  EXPECT_TRUE(dut->node_valid_o);
  children(2, {});
  expect_visit(2, 13);
  leaf_over(2);
  expect_done(2);
  dut->count_ctx_i = 2;
  dut.settle();
  EXPECT_EQ(dut->count_o, 3u);
}

TEST_F(StepUnit, VisitsAtTheReachAndDropsTheFrameBehindIt) {
  start(0, entry(RefNode, 1).target);
  children(0, nodes({entry(RefNode, 2, 10), entry(RefLeaf, 3, 100), entry(RefLeaf, 4, 101)}));
  children(0, nodes({entry(RefLeaf, 5, 20), entry(RefLeaf, 6, 101), entry(RefLeaf, 7, 101)}));
  dut->reach_i = 100;
  leaf_over(0);                       // the upper frame is dropped,
  EXPECT_FALSE(dut->node_valid_o || dut->leaf_valid_o || dut->done_valid_o);
  dut.tick(), dut.tick(), dut.tick();   // and the context decides again
  expect_visit(0, 3);
  leaf_over(0);
  dut.tick(), dut.tick(), dut.tick();
  expect_done(0);
}

TEST_F(StepUnit, AFullStackIsEnoughAndOneFrameMoreIsAnError) {
  const visits_t two = nodes({entry(RefNode, 1), entry(RefLeaf, 2)});
  start(1, entry(RefNode, 0).target);
  for (int i = 0; i < kDepth; ++i) {
    children(1, two);
    expect_visit(1, 1);
  }
  children(1, nodes({entry(RefNode, 3)}));   // leaves nothing behind
  expect_visit(1, 3);
  children(1, two);
  expect_fault(ErrStack);
}

TEST_F(StepUnit, TheLastNodeOfTheLimitIsVisited) {
  dut->limit_i = 3;
  start(4, entry(RefTile, 0).target, entry(RefTile, 1).target);
  expect_visit(4, 0);
  children(4, nodes({entry(RefNode, 7)}));
  expect_visit(4, 7);
  children(4, nodes({entry(RefLeaf, 8)}));
  expect_visit(4, 8);
  leaf_over(4);
  expect_visit(4, 1);
  children(4, nodes({entry(RefLeaf, 9), entry(RefNode, 5)}));
  expect_visit(4, 9);
  leaf_over(4);
  expect_fault(ErrSteps);
}

TEST_F(StepUnit, AHitThatWillDoLeavesTheStackAndTheNextRayStartsWithout) {
  start(3, entry(RefNode, 1).target);
  children(3, nodes({entry(RefLeaf, 2), entry(RefLeaf, 3)}));
  dut->stop_i = 1;
  leaf_over(3);
  expect_done(3);
  dut->stop_i = 0;
  dut.tick(), dut.tick();
  start(3, entry(RefLeaf, 4).target);
  expect_visit(3, 4);
  leaf_over(3);
  expect_done(3);
  dut->count_ctx_i = 3;
  dut.tick();
  EXPECT_EQ(dut->count_o, 0u);
}

TEST_F(StepUnit, ARayThatStartsNowhereIsDone) {
  start(5, {});
  expect_done(5);
}

// Leaves end in one cycle after another while nodes' children come in each; then the frames drop.
TEST_F(StepUnit, KeepsAllContextsWhileOthersAreServed) {
  constexpr int kLeaves = kContexts - 3;
  for (int ctx = 0; ctx < kContexts; ++ctx) {
    start(ctx, entry(RefNode, 1).target);
    children(ctx, nodes({entry(RefLeaf, 2), entry(RefLeaf, 3, 50)}));
  }
  dut.tick(), dut.tick();
  for (int i = 0; i < 4 * kLeaves; ++i) {
    dut->leaf_valid_i = i < kLeaves, dut->leaf_ctx_i = i;
    const int ctx = kLeaves + i % 3;
    children(ctx, nodes({entry(RefNode, 30)}), false);   // one decision a cycle
    expect_visit(ctx, 30);
  }
  dut->reach_i = 49;
  int done = 0;
  for (int cycle = 0; cycle < 3 * kLeaves; ++cycle) {
    dut.tick();
    EXPECT_FALSE(dut->node_valid_o || dut->leaf_valid_o);
    done += dut->done_valid_o;
  }
  EXPECT_EQ(done, kLeaves);
}

}  // namespace
}  // namespace castray::tb
