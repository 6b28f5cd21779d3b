// SPDX-License-Identifier: Apache-2.0
#include "scene/tree_facts.hpp"

#include <algorithm>

#include "mem/image.hpp"
#include "scene/node.hpp"

namespace castray {

TreeFacts tree_facts(const SceneImage& image) {
  const std::uint8_t* const bytes = image.bytes.data();
  const image_header_t& header = image.header;
  TreeFacts facts;
  facts.nodes = header.nodes.count;
  facts.leaves = header.lines.count;
  std::uint64_t children = 0, primitives = 0;
  double scene_area = 0;
  std::vector<unsigned> depth(header.nodes.count, 1);
  for (std::uint64_t at = 0; at < header.nodes.count; ++at) {  // a parent lies before its children
    facts.depth = std::max(facts.depth, depth[at]);
    const std::vector<NodeChild> below = node_children(load_node(bytes, header, at));
    if (at == ref_index(header.root)) {
      Box all;
      for (const NodeChild& child : below) all.add(child.box);
      scene_area = all.half_area();
      facts.nodes_met = scene_area;
    }
    for (const NodeChild& child : below) {
      ++children;
      const std::uint64_t index = ref_index(child.word);
      if (ref_kind(child.word) == RefNode) {
        depth[index] = depth[at] + 1;
        facts.nodes_met += child.box.half_area();
        continue;
      }
      unsigned tests = 0;
      for (std::uint64_t slot = 2 * index; slot < 2 * index + 2; ++slot) tests += load_slot(bytes, header, slot).number != std::uint64_t{NoPrim};
      primitives += tests;
      facts.leaves_met += child.box.half_area();
      facts.tests_met += child.box.half_area() * tests;
    }
  }
  facts.children = double(children) / double(facts.nodes);
  facts.occupancy = double(primitives) / double(facts.leaves);
  for (double* met : {&facts.nodes_met, &facts.leaves_met, &facts.tests_met}) *met /= scene_area;
  return facts;
}

}  // namespace castray
