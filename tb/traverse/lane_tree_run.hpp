// SPDX-License-Identifier: Apache-2.0
// Rays through a lane and through its model, on a scene image in a memory with stalls.
#pragma once
#include <map>

#include "../scene/ray_maker.hpp"
#include "Vlane_tree.h"
#include "line_memory_model.hpp"
#include "tree_port.hpp"

namespace castray::tb {

struct LaneRay {
  ray_t ray;
  start_t start;
};

// What was compared so far.
struct LaneTotals {
  long rays = 0, hits = 0, nodes = 0, tests = 0;
};

class LaneTree {
 public:
  LaneTree(const SceneImage& image, Stalls stalls, unsigned seed, int delay = 20)
      : tree{.image = image.bytes.data(), .header = &image.header, .limit = 1 << 20},
        stalls_(stalls), image_(image), dut_(seed),
        nodes_([this](line_no_t line) { return line_at(image_, line); }, stalls, seed + 1, delay),
        leaves_([this](line_no_t line) { return line_at(image_, line); }, stalls, seed + 2, delay),
        source_(stalls.source, stalls.burst, seed + 3), sink_(stalls.sink, stalls.burst, seed + 4) {
    dut_->in_valid_i = dut_->tile_write_i = 0;
  }

  // The nodes of tiles' frontiers.
  void write_tile(const std::vector<node_t>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      dut_->tile_write_i = 1, dut_->tile_index_i = i;
      set_port(dut_->tile_node_i, nodes[i]);
      cycle();
    }
    dut_->tile_write_i = 0;
    tile_ = nodes;
    tree.tile = tile_;
  }

  // Every ray's hit, nodes and tests are the model's. Tags must differ.
  void expect_hits(const std::vector<LaneRay>& rays) {
    std::map<std::uint64_t, const LaneRay*> under_way;
    std::size_t next = 0, given = 0;
    bool offering = false;
    set_tree();
    const long first = cycles, limit = 20000 + 4000L * static_cast<long>(rays.size());
    while (given < rays.size()) {
      ASSERT_LT(cycles - first, limit) << "rays wait for ever";
      if (!offering && next < rays.size()) offering = source_.open();
      dut_->in_valid_i = offering;
      if (offering) set_port(dut_->in_i, rays[next].ray), set_port(dut_->start_i, rays[next].start);
      dut_->out_ready_i = sink_.open();
      dut_.settle();
      ASSERT_EQ(dut_->fault_o, ErrNone);
      if (dut_->out_valid_o && dut_->out_ready_i) {
        const hit_t hit = get_port<hit_t>(dut_->out_o);
        const auto at = under_way.find(key(hit.tag));
        ASSERT_NE(at, under_way.end()) << "a hit of no ray: " << to_text(hit);
        ASSERT_NO_FATAL_FAILURE(compare(*at->second, hit, get_port<work_t>(dut_->work_o)));
        under_way.erase(at);
        ++given;
      }
      if (offering && dut_->in_ready_o) {
        under_way[key(rays[next].ray.tag)] = &rays[next];
        ++next, offering = false;
      }
      cycle();
    }
    dut_->in_valid_i = 0;
    dut_.settle();
    EXPECT_TRUE(dut_->empty_o);
  }

  // One ray, from a reset: its error is the model's, and without one so is its hit.
  error_t expect_one(const LaneRay& ray) {
    dut_->in_valid_i = 0;
    dut_.reset();
    forget();
    set_tree();
    const TreeHit model = lane(ray.ray, tree, ray.start, [](const cand_t&, const result_t*) {});
    dut_->in_valid_i = dut_->out_ready_i = 1;
    set_port(dut_->in_i, ray.ray), set_port(dut_->start_i, ray.start);
    bool taken = false;
    const long limit = cycles + 20000 + 1000L * static_cast<long>(model.work.nodes);
    while (cycles < limit) {
      dut_.settle();
      taken = taken || dut_->in_ready_o;
      if (dut_->fault_o != ErrNone) {
        EXPECT_EQ(error_t(dut_->fault_o), model.error);
        return model.error;
      }
      if (dut_->out_valid_o) {
        EXPECT_EQ(model.error, ErrNone);
        compare(ray, get_port<hit_t>(dut_->out_o), get_port<work_t>(dut_->work_o));
        cycle();
        return model.error;
      }
      cycle();
      if (taken) dut_->in_valid_i = 0;
    }
    ADD_FAILURE() << "the ray waits for ever: " << to_text(ray.ray) << ", the model says " << model.error;
    return model.error;
  }

  Tree tree;
  long cycles = 0;
  std::map<std::string, long> events;
  LaneTotals totals;

 private:
  static std::uint64_t key(const pixel_tag_t& tag) { return pack(tag)[0]; }

  void set_tree() { set_port(dut_->tree_i, tree_port(tree)); }
  // What memory still owes to a lane that was reset.
  void forget() {
    nodes_ = LineMemoryModel([this](line_no_t line) { return line_at(image_, line); }, stalls_, 1);
    leaves_ = LineMemoryModel([this](line_no_t line) { return line_at(image_, line); }, stalls_, 2);
  }

  void compare(const LaneRay& ray, const hit_t& hit, const work_t& work) {
    const TreeHit model = lane(ray.ray, tree, ray.start, [](const cand_t&, const result_t*) {});
    ASSERT_EQ(model.error, ErrNone);
    ASSERT_EQ(to_text(hit), to_text(model.hit)) << to_text(ray.ray);
    ASSERT_EQ(to_text(work), to_text(model.work)) << to_text(ray.ray);
    ++totals.rays, totals.hits += static_cast<long>(hit.found);
    totals.nodes += static_cast<long>(work.nodes), totals.tests += static_cast<long>(work.tests);
  }

  // The memories' part of a cycle, and the clock.
  void cycle() {
    dut_->node_req_ready_i = nodes_.request_ready();
    dut_->leaf_req_ready_i = leaves_.request_ready();
    const line_fill_t* const node = nodes_.offered();
    const line_fill_t* const leaf = leaves_.offered();
    dut_->node_fill_valid_i = node != nullptr;
    dut_->leaf_fill_valid_i = leaf != nullptr;
    if (node) set_port(dut_->node_fill_i, *node);
    if (leaf) set_port(dut_->leaf_fill_i, *leaf);
    dut_.settle();
    get_port<lane_events_t>(dut_->events_o).each_field([&](std::string_view name, const auto& value, int, int, bool) {
      if (value) ++events[std::string(name)];
    });
    nodes_.tick(dut_->node_req_valid_o, get_port<line_req_t>(dut_->node_req_o), node && dut_->node_fill_ready_o);
    leaves_.tick(dut_->leaf_req_valid_o, get_port<line_req_t>(dut_->leaf_req_o), leaf && dut_->leaf_fill_ready_o);
    dut_.tick();
    ++cycles;
  }

  Stalls stalls_;
  const SceneImage& image_;
  Dut<Vlane_tree> dut_;
  LineMemoryModel nodes_, leaves_;
  Gate source_, sink_;
  std::vector<node_t> tile_;
};

}  // namespace castray::tb
