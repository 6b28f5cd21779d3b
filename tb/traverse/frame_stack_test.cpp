// SPDX-License-Identifier: Apache-2.0
// The stacks of contexts: random looks, pushes, replacements and drops beside a model of each.
// Verilator: -GContexts=5 -GDepth=4
#include "traverse/frame_stack.hpp"

#include "Vframe_stack.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 5, kDepth = 4;

class FrameStackUnit : public testing::Test {
 protected:
  FrameStackUnit() {
    dut->look_i = dut->push_i = dut->replace_i = dut->drop_i = 0;
    for (int ctx = 0; ctx < kContexts; ++ctx) models.emplace_back(kDepth);
  }
  frame_t frame() {
    frame_t f;
    f.e0.least = rng() % 4096, f.e1.target.index = rng() % (1u << LineW), f.e2.target.kind = rng() % 4;
    return f;
  }
  // s1 of the context looked at, and s0 of the next one, in one cycle.
  void cycle(int next, bool fresh) {
    dut->push_i = dut->replace_i = dut->drop_i = 0;
    dut.settle();
    if (now >= 0) {
      FrameStack& model = models[static_cast<std::size_t>(now)];
      ASSERT_EQ(dut->empty_o, model.empty());
      ASSERT_EQ(dut->full_o, model.full());
      if (!model.empty()) ASSERT_EQ(to_text(get_port<frame_t>(dut->top_o)), to_text(model.top()));
      const frame_t f = frame();
      set_port(dut->frame_i, f);
      const auto what = rng() % 5;
      if (what < 2 && !model.full()) dut->push_i = 1, model.push(f);
      else if (what == 2 && !model.empty()) dut->replace_i = 1, model.top() = f;
      else if (what == 3 && !model.empty()) dut->drop_i = 1, dut->replace_i = rng() % 2, model.drop();
      full += model.full();
    }
    dut->look_i = next >= 0;
    dut->look_ctx_i = std::max(next, 0);
    dut->look_new_i = fresh;
    if (next >= 0 && fresh) models[static_cast<std::size_t>(next)] = FrameStack(kDepth);
    dut.tick();
    before = now, now = next;
  }

  std::mt19937 rng{3};
  Dut<Vframe_stack> dut;
  std::vector<FrameStack> models;
  int now = -1, before = -1, full = 0;   // in s1, in s2
};

TEST_F(FrameStackUnit, MatchesModel) {
  for (int ctx = 0; ctx < kContexts; ++ctx) cycle(ctx, true);
  for (int i = 0; i < 20000; ++i) {
    int next = static_cast<int>(rng() % (kContexts + 1)) - 1;
    if (next == now || next == before) next = -1;
    cycle(next, rng() % 40 == 0);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(full, 1000);
}

}  // namespace
}  // namespace castray::tb
