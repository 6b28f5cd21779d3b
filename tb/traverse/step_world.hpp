// SPDX-License-Identifier: Apache-2.0
// Contexts that walk random trees through the unit step, each beside a model of its own.
#pragma once
#include <map>
#include <optional>

#include "Vstep.h"
#include "dut.hpp"
#include "traverse/step.hpp"

namespace castray::tb {

inline constexpr int kContexts = 6, kDepth = 4;   // as the test's flags set them

struct Shape {
  int children = 4;        // of a node, at most
  double leaves = 0.5;     // share of leaves among them
  double hits = 0.6;       // leaves that bring the reach nearer
  double any_hit = 0.2;    // rays that stop at a hit
  double delay = 0.5;      // chance that a result waits another cycle
  steps_t limit = 1000;
};

class StepWorld {
 public:
  StepWorld(const Shape& shape, unsigned seed) : shape_(shape), rng_(seed), dut_(seed) {}

  // Runs until `rays` have ended; every output is compared with the model of its context.
  void run(int rays) {
    for (long cycle = 0; ended_ < rays; ++cycle) {
      ASSERT_LT(cycle, 200L * rays + 1000) << "contexts wait for ever";
      drive();
      dut_.settle();
      const Context& asked = contexts_[std::min<int>(dut_->ask_ctx_o, kContexts - 1)];
      dut_->reach_i = asked.reach;
      dut_->stop_i = asked.any_hit && asked.found;
      dut_.settle();
      ASSERT_NO_FATAL_FAILURE(observe());
      if (dut_->start_valid_i && dut_->start_ready_o) begin(dut_->start_ctx_i);
      dut_.tick();
      if (counted_ >= 0) count(counted_);
    }
    EXPECT_GT(dones, 0);
  }

  int dones = 0, visits = 0, drops = 0;
  std::map<error_t, int> errors;

 private:
  enum class Wait { Free, Node, Leaf, Decision };
  struct Context {
    Wait wait = Wait::Free;
    std::optional<Step> model;
    Step::Next next = Step::Next::Done;
    dist_t reach = 0;
    bool any_hit = false, found = false;
  };

  int in(int low, int high) { return low + static_cast<int>(rng_() % static_cast<unsigned>(high - low + 1)); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(rng_) < p; }
  ref_t ref(std::uint64_t kind) {
    ref_t r;
    r.kind = kind, r.index = static_cast<line_t>(in(0, (1 << LineW) - 1));
    return r;
  }

  visits_t children() {
    visits_t v;
    entry_t* const entries[] = {&v.e0, &v.e1, &v.e2, &v.e3};
    const int count = in(0, shape_.children);
    dist_t dist = 0;
    for (int i = 0; i < count; ++i) {
      dist += static_cast<dist_t>(in(0, 400));
      entries[i]->least = dist;
      entries[i]->target = ref(static_cast<std::uint64_t>(chance(shape_.leaves) ? RefLeaf : RefNode));
    }
    return v;
  }
  start_t start() {
    start_t s;
    const int kind = in(0, 9);
    if (kind == 0) return s;                                   // nowhere
    s.first = ref(static_cast<std::uint64_t>(kind < 4 ? RefTile : kind < 9 ? RefNode : RefLeaf));
    if (kind < 3) s.second = ref(RefTile);
    return s;
  }

  // A context among those that wait for `wait`, whose result is due.
  int due(Wait wait) {
    const int first = in(0, kContexts - 1);
    for (int i = 0; i < kContexts; ++i) {
      const int ctx = (first + i) % kContexts;
      if (contexts_[ctx].wait == wait && ctx != last_ && !chance(shape_.delay)) return ctx;
    }
    return -1;
  }

  void decide(int ctx, const visits_t& visits) {
    Context& c = contexts_[ctx];
    const bool stop = c.any_hit && c.found;
    c.wait = Wait::Decision;
    c.next = c.model->decide(visits, c.reach, stop);
    for (; c.next == Step::Next::Again; c.next = c.model->decide({}, c.reach, stop)) ++drops;
  }

  void drive() {
    dut_->limit_i = shape_.limit;
    dut_->node_valid_i = dut_->leaf_valid_i = 0;
    if (const int ctx = due(Wait::Node); ctx >= 0) {
      const visits_t visits = children();
      dut_->node_valid_i = 1;
      dut_->node_ctx_i = ctx;
      set_port(dut_->node_i, visits);
      decide(ctx, visits);
    }
    if (const int ctx = due(Wait::Leaf); ctx >= 0) {
      Context& c = contexts_[ctx];
      if (chance(shape_.hits)) c.found = true, c.reach = static_cast<dist_t>(in(0, static_cast<int>(c.reach)));
      dut_->leaf_valid_i = 1;
      dut_->leaf_ctx_i = ctx;
      decide(ctx, {});
    }
    dut_->start_valid_i = offered_ >= 0;
    if (offered_ < 0 && (offered_ = due(Wait::Free)) >= 0) {
      dut_->start_valid_i = 1;
      dut_->start_ctx_i = offered_;
      start_ = start();
      set_port(dut_->start_i, start_);
    }
  }

  // The offered ray is taken.
  void begin(int ctx) {
    Context& c = contexts_[ctx];
    c.model.emplace(shape_.limit, kDepth);
    c.reach = static_cast<dist_t>(in(0, 4095));
    c.any_hit = chance(shape_.any_hit), c.found = false;
    decide(ctx, visits_of(start_));
    offered_ = -1;
  }

  void observe() {
    counted_ = -1;
    const int before = last_;
    last_ = dut_->out_ctx_o;
    if (dut_->fault_o != ErrNone) {   // of the decision before
      Context& c = contexts_[before];
      ASSERT_EQ(int(c.wait), int(Wait::Decision)) << "context " << before << " had nothing to decide";
      ASSERT_EQ(int(c.next), int(Step::Next::Failed));
      EXPECT_EQ(dut_->fault_o, c.model->error());
      c.wait = Wait::Free;
      ++errors[static_cast<error_t>(dut_->fault_o)];
      ++ended_;
    }
    const int outputs = dut_->node_valid_o + dut_->leaf_valid_o + dut_->done_valid_o;
    ASSERT_LE(outputs, 1);
    if (outputs == 0) return;
    const int ctx = last_;
    ASSERT_LT(ctx, kContexts);
    Context& c = contexts_[ctx];
    ASSERT_EQ(int(c.wait), int(Wait::Decision)) << "context " << ctx << " had nothing to decide";
    c.wait = Wait::Free;
    if (dut_->done_valid_o) {
      ASSERT_EQ(int(c.next), int(Step::Next::Done));
      counted_ = ctx;
      ++dones, ++ended_;
    } else {
      ASSERT_EQ(int(c.next), int(Step::Next::Visit));
      EXPECT_EQ(to_text(get_port<ref_t>(dut_->out_ref_o)), to_text(c.model->target()));
      const bool leaf = c.model->target().kind == static_cast<std::uint64_t>(RefLeaf);
      EXPECT_EQ(bool(dut_->leaf_valid_o), leaf);
      c.wait = leaf ? Wait::Leaf : Wait::Node;
      ++visits;
    }
  }

  void count(int ctx) {
    dut_->count_ctx_i = ctx;
    dut_.settle();
    EXPECT_EQ(dut_->count_o, contexts_[ctx].model->nodes());
  }

  Shape shape_;
  std::mt19937 rng_;
  Dut<Vstep> dut_;
  Context contexts_[kContexts];
  start_t start_;
  int offered_ = -1;   // the context of the ray that waits to be taken
  int counted_ = -1;   // the context that is done
  int last_ = -1;      // in s1 in the last cycle: nothing more comes of it yet
  int ended_ = 0;
};

}  // namespace castray::tb
