// SPDX-License-Identifier: Apache-2.0
// From references to children: nodes of an image through a small cache, nodes on the chip, and errors,
// for contexts of both steps at once, beside the model.
// Links the library.
// Verilator: -GContexts=6 -GLines=16 -GTileNodes=8
#include "traverse/node_visits.hpp"

#include "../isect/visits_read.hpp"
#include "../scene/ray_maker.hpp"
#include "Vnode_visits.h"
#include "line_memory_model.hpp"
#include "scene/load.hpp"
#include "signed_port.hpp"
#include "traverse/ray_store.hpp"
#include "tree_port.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 6;

class NodeVisits : public testing::TestWithParam<Stalls> {
 protected:
  struct Context {
    bool waits = false;
    ref_t ref;
    ray_t ray;
    t_t t = 0;
  };

  NodeVisits() : contexts(kContexts) {
    dut->base_i = image.header.nodes.offset / LineBytes;
    dut->count_i = image.header.nodes.count;
    dut->visit_valid_i = dut->tile_write_i = dut->fill_valid_i = dut->req_ready_i = 0;
    for (std::size_t i = 0; i < tile.size(); ++i) tile[i] = load_node(image.bytes.data(), image.header, i * 7);
    for (std::size_t i = 0; i < tile.size(); ++i, dut.tick()) {
      dut->tile_write_i = 1, dut->tile_index_i = i;
      set_port(dut->fill_i, line_of(tile[i]));
    }
    dut->tile_write_i = 0;
  }

  void visit(int ctx, Context to) {
    to.waits = true;
    contexts[ctx] = to;
    dut->visit_valid_i |= 1 << ctx % 2, dut->visit_ctx_i[ctx % 2] = ctx;
    set_port(dut->visit_ref_i[ctx % 2], to.ref);
  }
  error_t model(const Context& c, visits_t& visits) {
    return node_visits(image.bytes.data(), image.header, tile, c.ref, slab_ray_of(c.ray), c.t, visits);
  }

  // One cycle with its memory. The context whose children came, or -1.
  int cycle(LineMemoryModel& memory) {
    memory.drive(dut);
    if (written) set_port(dut->fill_i, line_of(*written));
    dut.settle();
    const Context& tested = contexts[std::min<int>(dut->ray_ctx_o, kContexts - 1)];
    set_port(dut->ray_i, slab_ray_of(tested.ray));
    set_signed(dut->t_i, tested.t, t_t_bits);
    dut.settle();
    tests += dut->node_o;
    fault = static_cast<error_t>(dut->fault_o);
    int came = -1;
    if (dut->out_valid_o) came = dut->out_ctx_o, visits = as_read(get_port<visits_t>(dut->out_o));
    memory.observe(dut);
    dut.tick();
    dut->visit_valid_i = dut->tile_write_i = 0;
    written = nullptr;
    return came;
  }
  static line_fill_t line_of(const node_t& node) {
    line_fill_t fill;
    const auto words = pack(node);
    std::copy(words.begin(), words.end(), fill.data.begin());
    return fill;
  }
  LineMemoryModel memory_of(const Stalls& stalls) {
    return {[this](line_no_t line) { return line_at(image, line); }, stalls, 5};
  }

  SceneImage image = compile(load_scene("scenes/teapot.json"), 320, 240);
  std::vector<node_t> tile = std::vector<node_t>(8);
  std::vector<Context> contexts;
  visits_t visits;
  const node_t* written = nullptr;   // a tile's node, in this cycle
  error_t fault = ErrNone;
  long tests = 0;
  Dut<Vnode_visits> dut;
};
INSTANTIATE_TEST_SUITE_P(Patterns, NodeVisits, testing::ValuesIn(kStallPatterns));

TEST_P(NodeVisits, MatchesModel) {
  LineMemoryModel memory = memory_of(GetParam());
  RayMaker rays(image, 1);
  std::mt19937 rng(4);
  int given = 0, some = 0;
  for (long cycles = 0; given < 3000; ++cycles) {
    ASSERT_LT(cycles, 300000) << "contexts wait for ever";
    for (int step = 0; step < 2; ++step) {
      const int ctx = step + 2 * static_cast<int>(rng() % (kContexts / 2));
      if (contexts[ctx].waits) continue;
      Context c;
      c.ray = rays.make();
      c.t = c.ray.tmax;
      const bool near_root = rng() % 2;
      c.ref.kind = static_cast<std::uint64_t>(rng() % 4 ? RefNode : RefTile);
      c.ref.index = rng() % (c.ref.kind == RefTile ? 8 : near_root ? 3 : image.header.nodes.count);
      visit(ctx, c);
    }
    const std::size_t fresh = rng() % tile.size();   // a tile's node is written while others are read
    const auto at_fresh = [&](const Context& c) { return c.waits && c.ref.kind == RefTile && c.ref.index == fresh; };
    if (rng() % 2 && std::none_of(contexts.begin(), contexts.end(), at_fresh)) {
      tile[fresh] = load_node(image.bytes.data(), image.header, rng() % 50);
      dut->tile_write_i = 1, dut->tile_index_i = fresh;
      written = &tile[fresh];
    }
    const int ctx = cycle(memory);
    ASSERT_EQ(fault, ErrNone);
    if (ctx < 0) continue;
    ASSERT_TRUE(contexts[ctx].waits) << "context " << ctx << " asked for nothing";
    visits_t expected;
    ASSERT_EQ(model(contexts[ctx], expected), ErrNone);
    ASSERT_EQ(to_text(visits), to_text(expected));
    contexts[ctx].waits = false;
    ++given;
    some += expected.e0.target.kind != 0;
  }
  EXPECT_GT(some, 300);
  for (int i = 0; i < 1000; ++i)
    if (const int ctx = cycle(memory); ctx >= 0) contexts[ctx].waits = false;
  for (const Context& c : contexts) EXPECT_FALSE(c.waits) << "a node was lost";
}

TEST_F(NodeVisits, AnErrorGivesNothing) {
  LineMemoryModel memory = memory_of({});
  const auto node_word = [](std::uint64_t index) { return static_cast<ref_word_t>(RefNode) << LineW | index; };
  node_t wrong = load_node(image.bytes.data(), image.header, 3);
  wrong.ref0 = node_word(3);   // below itself
  store_record(&image.bytes[image.header.nodes.offset + 3 * NodeBytes], wrong);
  wrong.ref0 = 0xffffffff;     // no reference
  store_record(&image.bytes[image.header.nodes.offset + 4 * NodeBytes], wrong);
  wrong.ref0 = node_word(6), wrong.ref1 = wrong.ref2 = wrong.ref3 = 0;
  store_record(&image.bytes[image.header.nodes.offset + 5 * NodeBytes], wrong);
  for (const std::uint64_t index : {std::uint64_t{3}, std::uint64_t{4}, std::uint64_t{5}, image.header.nodes.count}) {
    Context c;
    c.ref.kind = RefNode, c.ref.index = index;
    const error_t expected = model(c, visits);
    EXPECT_EQ(expected, index == 5 ? ErrNone : ErrNode);
    visit(2, c);
    int faults = 0, came = 0;
    for (int i = 0; i < 400; ++i) {
      came += cycle(memory) >= 0;
      faults += fault != ErrNone;
      if (fault != ErrNone) EXPECT_EQ(fault, ErrNode);
    }
    EXPECT_EQ(came, index == 5) << index;
    EXPECT_EQ(faults, index != 5) << index;
  }
}

// From the visit to the children: 5 cycles to the node where the cache holds it, 4 to a tile's, and the
// node pipe's 7.
TEST_F(NodeVisits, TakeTwelveCyclesOrEleven) {
  LineMemoryModel memory = memory_of({});
  Context c;
  c.ref.kind = RefNode, c.ref.index = 0;
  for (int round = 0; round < 2; ++round) {
    visit(1, c);
    int cycles = 0;
    while (cycle(memory) < 0 && cycles < 1000) ++cycles;
    if (round == 1) EXPECT_EQ(cycles, 12);
  }
  c.ref.kind = RefTile;
  visit(1, c);
  int cycles = 0;
  while (cycle(memory) < 0 && cycles < 1000) ++cycles;
  EXPECT_EQ(cycles, 4 + 7);
}

}  // namespace
}  // namespace castray::tb
