// SPDX-License-Identifier: Apache-2.0
// Sends nodes through the node pipe and compares each result with the model; cases made by hand.
#pragma once
#include "Vnode_pipe.h"
#include "dut.hpp"
#include "node_cases.hpp"
#include "signed_port.hpp"
#include "visits_read.hpp"

namespace castray::tb {

inline constexpr int kLatency = 7;

inline void offer(Dut<Vnode_pipe>& dut, const NodeCase& c) {
  set_port(dut->in_ctx_i, c.ctx);
  set_port(dut->in_ray_i, c.ray);
  set_port(dut->in_node_i, c.node);
  set_signed(dut->in_t_i, c.t, t_t_bits);
}

// Sends the cases with the source's gaps and compares each result with the model.
inline std::vector<visits_t> run(const std::vector<NodeCase>& cases, Stalls stalls = {}, unsigned seed = 1) {
  Dut<Vnode_pipe> dut(seed);
  Gate source(stalls.source, stalls.burst, seed);
  std::deque<std::pair<long, const NodeCase*>> pending;
  std::vector<visits_t> results;
  std::size_t next = 0;
  for (long cycle = 0; results.size() < cases.size() && !testing::Test::HasFailure(); ++cycle) {
    const bool offered = next < cases.size() && source.open();
    dut->in_valid_i = offered;
    if (offered) {
      offer(dut, cases[next]);
      pending.emplace_back(cycle, &cases[next++]);
    }
    dut.settle();
    const bool due = !pending.empty() && pending.front().first + kLatency == cycle;
    EXPECT_EQ(dut->out_valid_o, due) << "cycle " << cycle;
    if (due) {
      const NodeCase& c = *pending.front().second;
      pending.pop_front();
      bool illegal = false;
      const visits_t want = node_pipe(c.ray, c.node, c.t, illegal), got = as_read(get_port<visits_t>(dut->out_o));
      EXPECT_TRUE(got == want && dut->error_o == illegal && dut->out_ctx_o == c.ctx)
          << to_text(c) << "\nmodel " << castray::to_text(want) << " error " << illegal << "\nRTL   " << castray::to_text(got)
          << " error " << int{dut->error_o};
      results.push_back(got);
    }
    dut.tick();
  }
  return results;
}

inline visits_t run_one(const NodeCase& c) {
  const auto results = run({c});
  return results.empty() ? visits_t{} : results[0];
}

inline int count(const visits_t& visits) {
  int n = 0;
  while (n < 4 && entry(visits, n).target.kind != RefNone) ++n;
  return n;
}

// A ray from the middle of the grid along its dominant axis, and a node around it whose planes are a
// step apart, the 100th through its origin.
inline NodeCase straight(axis_t axis = 2, bool neg = false) {
  NodeCase c;
  c.ray.org.x = c.ray.org.y = c.ray.org.z = static_cast<coord_t>(kHalf);
  c.ray.axis = axis, c.ray.neg = neg;
  set_shear(c, 0, 0);
  c.node.x = c.node.y = c.node.z = static_cast<coord_t>(kHalf - 100);
  return c;
}
inline child_box_t whole_box() { return {.x0 = 0, .y0 = 0, .z0 = 0, .x1 = 255, .y1 = 255, .z1 = 255}; }
inline void set_child(NodeCase& c, int child, child_box_t box, ref_word_t word) {
  child_box_t* const boxes[] = {&c.node.box0, &c.node.box1, &c.node.box2, &c.node.box3};
  ref_word_t* const words[] = {&c.node.ref0, &c.node.ref1, &c.node.ref2, &c.node.ref3};
  *boxes[child] = box, *words[child] = word;
}
inline ref_word_t leaf(std::uint64_t index) { return static_cast<ref_word_t>(RefLeaf << LineW | index); }
inline ref_word_t inner(std::uint64_t index) { return static_cast<ref_word_t>(RefNode << LineW | index); }

}  // namespace castray::tb
