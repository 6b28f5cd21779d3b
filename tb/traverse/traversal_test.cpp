// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Two lanes: rays from tiles that start anywhere in the hierarchy, and by brute force. Every hit is the
// model's, what meets nothing joins them, and it is idle when all are out, not before.
// Links the library.
// Verilator: -GLanes=2 -GContexts=5 -GTileLog2=2 -GSlots=8
#include <map>

#include "../scene/ray_maker.hpp"
#include "Vtraversal.h"
#include "lane_work.hpp"
#include "line_memory_model.hpp"
#include "scene/load.hpp"
#include "traverse/tile_start.hpp"
#include "tree_port.hpp"

namespace castray::tb {
namespace {

constexpr int kLanes = 2, kSlots = 8, kClients = 2 * kLanes;
constexpr std::uint64_t kLinesAt = 0x12'3456'0000;   // of the primitives that brute force reads

class Traversal : public testing::TestWithParam<Stalls> {
 protected:
  Traversal() {
    dut_->is_list_i = dut_->brute_i = dut_->exhausted_i = dut_->starved_i = dut_->deal_valid_i = dut_->store_valid_i = 0;
    dut_->in_valid_i = dut_->miss_valid_i = dut_->rsp_valid_i = dut_->lines_i = 0;
    for (int i = 0; i < kClients; ++i) memory_.emplace_back([this](line_no_t line) { return line_at(*image_, line); }, GetParam(), 10u + static_cast<unsigned>(i));
  }

  // ---- Hierarchy ----
  void follow(const SceneImage& image) {
    image_ = &image;
    tree_ = {.image = image.bytes.data(), .header = &image.header, .limit = 1 << 20};
    set_port(dut_->tree_i, tree_port(tree_));
    set_port(dut_->root_i, tree_.root().first);
  }
  // Deals a tile of `rays` rays to a lane and sends them, behind the last hit of the tile before it in its slot.
  void send_tile(RayMaker& maker, int slot, int lane, std::uint64_t start, int rays) {
    while (!HasFatalFailure() && under_way_[slot] != 0) cycle();
    std::vector<node_t> nodes(2);
    for (unsigned second = 0; second < 2; ++second) {
      nodes[second] = load_node(tree_.image, *tree_.header, rng_() % tree_.header->nodes.count);
      dut_->store_valid_i = 1, dut_->store_slot_i = slot, dut_->store_second_i = second;
      set_port(dut_->store_node_i, nodes[second]);
      cycle();
      dut_->store_valid_i = 0;
    }
    started_t dealt;
    dealt.start = start, dealt.tile.slot = static_cast<std::uint64_t>(slot);
    dut_->deal_valid_i = 1, dut_->deal_lane_i = lane;
    set_port(dut_->deal_i, dealt);
    cycle();
    dut_->deal_valid_i = 0;
    for (int i = 0; i < rays && !HasFatalFailure(); ++i) {
      ray_t ray = maker.make();
      ray.tag.slot = static_cast<std::uint64_t>(slot);
      tree_.tile = nodes;
      const TreeHit model = castray::lane(ray, tree_, start_of(start, tree_.root().first), [](const cand_t&, const result_t*) {});
      ASSERT_EQ(model.error, ErrNone);
      send(ray, model.hit);
      ++dealt_[lane];
    }
  }

  // Rays of a list: 16 to each lane in turn.
  void send_list(RayMaker& maker, int rays) {
    dut_->is_list_i = 1;
    for (int i = 0; i < rays && !HasFatalFailure(); ++i) {
      const ray_t ray = maker.make();
      const TreeHit model = castray::lane(ray, tree_, tree_.root(), [](const cand_t&, const result_t*) {});
      ASSERT_EQ(model.error, ErrNone);
      send(ray, model.hit);
      ++dealt_[static_cast<std::size_t>(i / 16 % kLanes)];
    }
  }

  // ---- Brute force ----
  void set_primitives(const std::vector<prim_slot_t>& prims) {
    dut_->brute_i = 1;
    prims_ = slots_ = prims;
    if (slots_.size() % 2 != 0) slots_.emplace_back().number = NoPrim;
    tree_t tree;
    tree.leaf_count = slots_.size() / 2, tree.primitives = prims.size();
    set_port(dut_->tree_i, tree);
    dut_->lines_i = kLinesAt;
    dut_.reset();
  }
  void send_brute(const std::vector<ray_t>& rays) {
    std::uint64_t tests = 0;
    for (const ray_t& ray : rays)
      if (!HasFatalFailure()) send(ray, model_hit(ray, prims_, tests));
  }

  // ---- Both ----
  void send(const ray_t& ray, const hit_t& hit) {
    while (!source_.open()) cycle();
    set_port(dut_->in_i, ray);
    dut_->in_valid_i = 1;
    expect(hit);
    ++under_way_[static_cast<int>(ray.tag.slot)], found_ += hit.found;
    for (taken_ = false; !taken_ && !HasFatalFailure();) cycle();
    dut_->in_valid_i = 0;
  }
  void expect(const hit_t& hit) { ASSERT_TRUE(wanted_.emplace(pack(hit.tag)[0], hit).second) << "two of one tag"; }
  // No more rays come: until it is idle.
  void finish() {
    dut_->exhausted_i = 1;
    for (const long limit = dut_.cycles() + 200000; dut_.cycles() < limit && !HasFatalFailure(); cycle()) {
      dut_.settle();
      if (dut_->idle_o) break;
    }
    EXPECT_TRUE(dut_->idle_o);
    EXPECT_EQ(rays_out_, 0);
    while (!misses_.empty() && !HasFatalFailure()) cycle();
    EXPECT_TRUE(wanted_.empty());
    EXPECT_EQ(hits_, found_) << "the hits that are counted";
    dut_->exhausted_i = 0;
  }

  void cycle() {
    ASSERT_LT(dut_.cycles(), 2'000'000) << "rays wait for ever";
    const int fill = offer_fill();
    dut_->line_ready_i = 0;
    for (int i = 0; i < kClients; ++i) dut_->line_ready_i |= memory_[static_cast<std::size_t>(i)].request_ready() << i;
    dut_->read_ready_i = bus_.open();
    dut_->rsp_valid_i = !beats_.empty() && bus_.open();
    if (dut_->rsp_valid_i) set_port(dut_->rsp_i, beats_.front());
    if (!dut_->miss_valid_i && !misses_.empty() && source_.open()) dut_->miss_valid_i = 1, set_port(dut_->miss_i, misses_.back());
    dut_->out_ready_i = sink_.open();
    dut_.settle();
    ASSERT_EQ(dut_->fault_o, ErrNone);
    ASSERT_FALSE(dut_->idle_o && rays_out_ != 0) << "idle with " << rays_out_ << " rays under way";
    if (dut_->out_valid_o && dut_->out_ready_i) ASSERT_NO_FATAL_FAILURE(take(get_port<cast_t>(dut_->out_o)));
    for (int lane = 0; lane < kLanes; ++lane) left_[lane] += dut_->left_o >> lane & 1, hits_ += dut_->hit_o >> lane & 1;
    for (int i = 0; i < kClients; ++i)
      memory_[static_cast<std::size_t>(i)].tick(dut_->line_valid_o >> i & 1, get_port<line_req_t>(dut_->line_o[i]), i == fill && dut_->fill_ready_o >> i & 1);
    if (fill >= 0 && dut_->fill_ready_o >> fill & 1) filling_ = -1;
    if (dut_->rsp_valid_i) beats_.pop_front();
    if (dut_->read_valid_o && dut_->read_ready_i) read(get_port<read_req_t>(dut_->read_o));
    taken_ = dut_->in_valid_i && dut_->in_ready_o, rays_out_ += taken_;
    const bool missed = dut_->miss_valid_i && dut_->miss_ready_o;
    dut_.tick();
    if (missed) dut_->miss_valid_i = 0, misses_.pop_back();
  }

  Dut<Vtraversal> dut_;
  std::mt19937 rng_{3};
  std::vector<pixel_tag_t> misses_;   // still to be given
  std::array<int, kLanes> dealt_{}, left_{};

 private:
  // The client whose line is on the bus, or -1.
  int offer_fill() {
    for (int k = 1; k <= kClients && filling_ < 0; ++k)
      if (const int i = (last_fill_ + k) % kClients; memory_[static_cast<std::size_t>(i)].offered()) filling_ = last_fill_ = i;
    dut_->fill_valid_i = filling_ < 0 ? 0 : 1 << filling_;
    if (filling_ >= 0) set_port(dut_->fill_i, *memory_[static_cast<std::size_t>(filling_)].offered());
    return filling_;
  }
  void read(const read_req_t& req) {
    for (std::uint64_t i = 0; i < req.beats; ++i) {
      const std::size_t at = req.addr - kLinesAt + i * StrbW;
      const auto words = pack(slots_.at(at / SlotBytes));
      read_rsp_t rsp;
      for (std::size_t w = 0; w < 4; ++w) rsp.data[w] = words[at % SlotBytes / 4 + w];
      rsp.last = i + 1 == req.beats;
      beats_.push_back(rsp);
    }
  }
  void take(const cast_t& cast) {
    hit_t hit = cast.hit;
    if (hit.tag.y == kMissRow) {   // of which the rest is not told
      ASSERT_EQ(to_text(cast.work), to_text(work_t{}));
      hit = {};
      hit.tag = cast.hit.tag, hit.found = cast.hit.found;
    }
    const auto at = wanted_.find(pack(hit.tag)[0]);
    ASSERT_NE(at, wanted_.end()) << "a hit of no ray: " << to_text(hit);
    ASSERT_EQ(to_text(hit), to_text(at->second));
    wanted_.erase(at);
    if (hit.tag.y < kMissRow) --under_way_[static_cast<int>(hit.tag.slot)], --rays_out_;
  }

 protected:
  static constexpr std::uint64_t kMissRow = 4095;   // where no ray is

 private:
  const SceneImage* image_ = nullptr;
  Tree tree_{};
  std::vector<prim_slot_t> prims_, slots_;   // the slots of whole lines
  std::vector<LineMemoryModel> memory_;
  std::deque<read_rsp_t> beats_;
  std::map<std::uint64_t, hit_t> wanted_;   // by tag
  std::map<int, int> under_way_;            // by slot
  int rays_out_ = 0, filling_ = -1, last_fill_ = 0;
  long found_ = 0, hits_ = 0;
  bool taken_ = false;
  Gate source_{GetParam().source, GetParam().burst, 1}, sink_{GetParam().sink, GetParam().burst, 2}, bus_{GetParam().source, GetParam().burst, 3};
};
INSTANTIATE_TEST_SUITE_P(Patterns, Traversal, testing::ValuesIn(kStallPatterns));

TEST_P(Traversal, FollowsTheHierarchyFromEachTilesStart) {
  const SceneImage image = compile(load_scene("scenes/teapot.json"), 320, 240);
  follow(image);
  RayMaker maker(image, 5);
  for (int i = 0; i < 40; ++i) {
    pixel_tag_t tag;
    tag.x = static_cast<std::uint64_t>(i), tag.y = kMissRow;
    misses_.push_back(tag);
    hit_t miss;
    miss.tag = tag;
    expect(miss);
  }
  for (int tile = 0; tile < 48 && !HasFatalFailure(); ++tile) {
    const std::int64_t starts[] = {TileRoot, TileOne, TileTwo};
    send_tile(maker, tile % kSlots, tile < 12 ? 0 : static_cast<int>(rng_() % kLanes), static_cast<std::uint64_t>(starts[rng_() % 3]), 1 + static_cast<int>(rng_() % 16));
  }
  finish();
  EXPECT_EQ(left_, dealt_);
  EXPECT_GT(dealt_[1], 50);
}

// One ray alone passes through its queue while the lanes have nothing else.
TEST_P(Traversal, IsNotIdleWithARayInAQueue) {
  const SceneImage image = compile(load_scene("scenes/spheres.json"), 64, 64);
  follow(image);
  RayMaker maker(image, 6);
  for (int i = 0; i < 20 && !HasFatalFailure(); ++i) {
    send_tile(maker, i % kSlots, i % kLanes, TileRoot, 1);
    finish();
  }
}

TEST_P(Traversal, DealsTheRaysOfAListInTurn) {
  const SceneImage image = compile(load_scene("scenes/teapot.json"), 320, 240);
  follow(image);
  RayMaker maker(image, 7);
  send_list(maker, 150);
  finish();
  EXPECT_EQ(left_, dealt_);
}

TEST_P(Traversal, TestsAllByBruteForce) {
  for (const int rays : {1, 2, 9, 10, 37}) {
    SCOPED_TRACE(rays);
    const Work work = random_work(static_cast<unsigned>(rays), rays, 33);
    set_primitives(work.prims);
    send_brute(work.rays);
    finish();
  }
}

// Every test of one lane's rays is a candidate, none of the other's is: the queue of the one fills.
TEST_P(Traversal, AFullLaneHoldsUpTheOther) {
  for (const unsigned busy : {0u, 1u}) {
    SCOPED_TRACE(busy);
    Work work = random_work(busy, 20, 80);
    for (std::size_t i = 0; i < work.rays.size(); ++i) work.rays[i].valid = i % kLanes == busy, work.rays[i].tmin = 0, work.rays[i].tmax = TMax;
    for (prim_slot_t& prim : work.prims) {
      prim.kind = KindSphere;
      prim.a.x = prim.a.y = prim.a.z = kMiddle;
      prim.b.x = 5000 + rng_() % 1000;
    }
    set_primitives(work.prims);
    send_brute(work.rays);
    finish();
  }
}

}  // namespace
}  // namespace castray::tb
