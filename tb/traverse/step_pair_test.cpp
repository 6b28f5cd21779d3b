// SPDX-License-Identifier: Apache-2.0
// Two steps: even and odd contexts are decided in the same cycle, each under its own number.
// Verilator: -GContexts=7
#include "Vstep_pair.h"
#include "dut.hpp"
#include "traverse/step.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 7;

class StepPair : public testing::Test {
 protected:
  StepPair() {
    dut->limit_i = 100;
    dut->start_valid_i = dut->node_valid_i = dut->leaf_valid_i = 0;
    dut->stop_i = 0;
    for (int i = 0; i < 2; ++i) dut->reach_i[i] = 4095;
  }
  static ref_t ref(std::int64_t kind, line_t index) {
    ref_t r;
    r.kind = static_cast<std::uint64_t>(kind), r.index = index;
    return r;
  }
  static visits_t children(line_t first, line_t second, dist_t least) {
    visits_t v;
    v.e0.target = ref(RefLeaf, first);
    v.e1.target = ref(RefNode, second), v.e1.least = least;
    return v;
  }
  void start(int ctx, line_t index) {
    start_t s;
    s.first = ref(RefNode, index);
    dut->start_valid_i = 1, dut->start_ctx_i = ctx;
    set_port(dut->start_i, s);
    dut.settle();
    EXPECT_TRUE(dut->start_ready_o);
    dut.tick();
    dut->start_valid_i = 0;
    dut.tick();
    expect_node(ctx, index);
    dut.tick(), dut.tick();
  }
  void node(int ctx, const visits_t& visits) {
    dut->node_valid_i = 1, dut->node_ctx_i = ctx;
    set_port(dut->node_i, visits);
  }
  void leaf(int ctx) { dut->leaf_valid_i = 1, dut->leaf_ctx_i = ctx; }
  void tick() {
    dut.tick();
    dut->node_valid_i = dut->leaf_valid_i = 0;
    dut.settle();
  }
  void expect_node(int ctx, line_t index) {
    dut.settle();
    EXPECT_TRUE(dut->node_valid_o >> ctx % 2 & 1);
    EXPECT_EQ(dut->out_ctx_o[ctx % 2], ctx);
    EXPECT_EQ(dut->ask_ctx_o[ctx % 2], ctx);
    EXPECT_EQ(to_text(get_port<ref_t>(dut->out_ref_o[ctx % 2])), to_text(ref(RefNode, index)));
  }
  Dut<Vstep_pair> dut;
};

TEST_F(StepPair, DecidesAnEvenAndAnOddContextAtOnce) {
  for (int ctx = 0; ctx < kContexts; ++ctx) start(ctx, static_cast<line_t>(100 + ctx));
  for (int ctx = 0; ctx < kContexts; ++ctx) {
    node(ctx, children(5, static_cast<line_t>(200 + ctx), static_cast<dist_t>(ctx)));
    tick();
    EXPECT_EQ(dut->leaf_valid_o, 1 << ctx % 2);
    EXPECT_EQ(dut->out_ctx_o[ctx % 2], ctx);
  }
  tick();
  for (int ctx = 0; ctx + 1 < kContexts; ctx += 2) {
    leaf(ctx + 1);
    tick();
    expect_node(ctx + 1, static_cast<line_t>(201 + ctx));
    tick(), tick();
    leaf(ctx);
    node(ctx + 1, {});
    tick();
    expect_node(ctx, static_cast<line_t>(200 + ctx));
    EXPECT_EQ(dut->done_valid_o, 2);
    EXPECT_EQ(dut->out_ctx_o[1], ctx + 1);
    tick();
    dut->count_ctx_i = ctx + 1;
    dut.settle();
    EXPECT_EQ(dut->count_o, 2u);
  }
}

TEST_F(StepPair, AsksForEachOfTwoContexts) {
  for (int ctx : {0, 1}) {
    start(ctx, 9);
    node(ctx, children(5, 6, 50));
    tick();
    tick();
  }
  dut->reach_i[0] = 49, dut->reach_i[1] = 50;   // the even one drops its frame
  leaf(0), tick();
  EXPECT_EQ(dut->node_valid_o, 0);
  leaf(1), tick();
  expect_node(1, 6);
  tick(), tick();
  EXPECT_EQ(dut->done_valid_o, 1);
  EXPECT_EQ(dut->out_ctx_o[0], 0);
}

TEST_F(StepPair, ABusyStepDoesNotHoldUpTheOther) {
  start(0, 9);
  start_t s;
  s.first = ref(RefNode, 7);
  set_port(dut->start_i, s);
  dut->start_valid_i = 1, dut->start_ctx_i = 2;
  dut.settle();
  EXPECT_TRUE(dut->start_ready_o);
  dut.tick();
  // The ray waits while nodes come for the even step, another even one finds no place, an odd one does.
  for (const int ctx : {0, 4, 6}) {
    node(ctx, children(5, 6, 50));
    dut->start_ctx_i = 4;
    dut.settle();
    EXPECT_FALSE(dut->start_ready_o);
    dut->start_ctx_i = 3;
    dut->start_valid_i = ctx == 0;
    dut.settle();
    if (ctx == 0) EXPECT_TRUE(dut->start_ready_o);
    dut.tick();
    EXPECT_EQ(dut->leaf_valid_o, 1) << "of " << ctx;
    dut->node_valid_i = dut->start_valid_i = 0;
    if (ctx == 4) expect_node(3, 7);
  }
  dut.tick();
  expect_node(2, 7);
}

TEST_F(StepPair, TellsTheErrorOfEither) {
  for (int ctx : {2, 5}) {
    dut->limit_i = 1;
    start(ctx, 9);
    visits_t v;
    v.e0.target = ref(RefNode, 10);
    node(ctx, v);
    tick();
    EXPECT_EQ(dut->fault_o, ErrNone);
    tick();
    EXPECT_EQ(dut->fault_o, ErrSteps);
    tick();
    EXPECT_EQ(dut->fault_o, ErrNone);
  }
}

}  // namespace
}  // namespace castray::tb
