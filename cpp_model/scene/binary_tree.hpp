// SPDX-License-Identifier: Apache-2.0
// The binary hierarchy of a set of boxes, built by the surface area heuristic.
#pragma once
#include <cstdint>
#include <vector>

#include "scene/box.hpp"

namespace castray {

struct BinaryNode {
  static constexpr std::uint32_t kLeaf = 0xffffffff;
  Box box;
  std::uint32_t left = 0;       // nodes; of a leaf: the number of its box
  std::uint32_t right = kLeaf;
  std::uint32_t count = 1;      // boxes below
  std::uint32_t height = 0;     // levels below: 0 for a leaf

  bool leaf() const { return right == kLeaf; }
};

// Node 0 is the root; children lie behind their parent.
using BinaryTree = std::vector<BinaryNode>;

// One leaf for each box, of which there is at least one. The same boxes give the same tree.
BinaryTree binary_tree(const std::vector<Box>& boxes);

// Box, count and height of each inner node from its children.
void complete(BinaryTree& tree);

// Makes the tree no higher than `most` levels, which is enough for a balanced one. Where a child is
// too large for the levels left to it, its parent's boxes are divided evenly, in their order.
void limit_height(BinaryTree& tree, std::uint32_t most);

}  // namespace castray
