// SPDX-License-Identifier: Apache-2.0
// Nodes on the chip: contexts of both steps get the node that was written last at their index.
// Verilator: -GContexts=6 -GNodes=16
#include "Vtile_nodes.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 6, kNodes = 16;

class TileNodes : public testing::TestWithParam<Stalls> {
 protected:
  TileNodes() { dut->write_i = dut->visit_valid_i = dut->out_ready_i = 0; }
  void write(int index, const node_t& node) {
    dut->write_i = 1, dut->write_index_i = index;
    set_port(dut->node_i, node);
  }
  void visit(int ctx, int index) {
    ref_t ref;
    ref.kind = RefTile, ref.index = static_cast<line_t>(index);
    dut->visit_valid_i |= 1 << ctx % 2, dut->visit_ctx_i[ctx % 2] = ctx;
    set_port(dut->visit_ref_i[ctx % 2], ref);
  }
  node_t random_node() {
    packed_t<node_t> words;
    for (std::uint32_t& word : words) word = rng();
    return unpack<node_t>(words.data());
  }
  std::mt19937 rng{2};
  Dut<Vtile_nodes> dut;
};
INSTANTIATE_TEST_SUITE_P(Patterns, TileNodes, testing::ValuesIn(kStallPatterns));

TEST_P(TileNodes, GivesEachContextItsNode) {
  Gate source(GetParam().source, GetParam().burst, 1), sink(GetParam().sink, GetParam().burst, 2);
  std::vector<node_t> nodes(kNodes);
  std::vector<int> waits(kContexts, -1);   // for which node
  int given = 0;
  for (int i = 0; i < kNodes; ++i, dut.tick()) write(i, nodes[i] = random_node());
  for (int cycle = 0; cycle < 8000; ++cycle) {
    dut->visit_valid_i = 0;
    for (int ctx = 0; ctx < kContexts; ++ctx)
      if (waits[ctx] < 0 && !(dut->visit_valid_i >> ctx % 2 & 1) && rng() % 2 && source.open()) visit(ctx, waits[ctx] = static_cast<int>(rng() % kNodes));
    const int fresh = static_cast<int>(rng() % kNodes);
    const node_t node = random_node();
    write(fresh, node);
    dut->write_i = std::count(waits.begin(), waits.end(), fresh) == 0;   // none waits for it
    dut->out_ready_i = sink.open();
    dut.settle();
    if (dut->out_valid_o && dut->out_ready_i) {
      int& index = waits[dut->out_ctx_o];
      ASSERT_GE(index, 0) << "context " << int(dut->out_ctx_o) << " asked for nothing";
      ASSERT_EQ(to_text(get_port<node_t>(dut->out_o)), to_text(nodes[static_cast<std::size_t>(index)]));
      index = -1;
      ++given;
    }
    if (dut->write_i) nodes[static_cast<std::size_t>(fresh)] = node;
    dut.tick();
  }
  EXPECT_GT(given, 1500);
  dut->visit_valid_i = dut->write_i = 0, dut->out_ready_i = 1;
  for (int cycle = 0; cycle < 2 * kContexts; ++cycle) {
    dut.settle();
    if (dut->out_valid_o) waits[dut->out_ctx_o] = -1;
    dut.tick();
  }
  EXPECT_EQ(std::count(waits.begin(), waits.end(), -1), kContexts) << "a node was lost";
}

TEST_F(TileNodes, OffersANodeTheCycleAfterItsContextCame) {
  const node_t node = random_node();
  write(3, node);
  dut.tick();
  dut->write_i = 0;
  visit(5, 3);
  dut.settle();
  EXPECT_FALSE(dut->out_valid_o);
  dut.tick();
  dut->visit_valid_i = 0;
  dut.settle();
  EXPECT_TRUE(dut->out_valid_o);
  EXPECT_EQ(dut->out_ctx_o, 5);
  EXPECT_EQ(to_text(get_port<node_t>(dut->out_o)), to_text(node));
}

}  // namespace
}  // namespace castray::tb
