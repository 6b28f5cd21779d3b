// SPDX-License-Identifier: Apache-2.0
// Which nodes of a binary tree become nodes of four children and which become leaves, so that the
// expected work of a ray is least: areas times what a node, a leaf and a test cost. The least cost of
// a subtree as a forest of one to three parts follows from its children's (Ylitie, Karras, Laine 2017).
#pragma once
#include <array>
#include <vector>

#include "scene/binary_tree.hpp"

namespace castray {

// Up to four nodes of a binary tree.
struct Parts {
  std::array<std::uint32_t, 4> node{};
  std::size_t count = 0;
  void add(std::uint32_t n) { node[count++] = n; }
};

class Collapse {
 public:
  explicit Collapse(const BinaryTree& tree);

  // True if the subtree is best a leaf, a line of one or two primitives.
  bool is_leaf(std::uint32_t node) const { return left_parts_[node][0] == 0; }

  // The best children of a node.
  Parts children(std::uint32_t node) const;

 private:
  void divide(std::uint32_t node, std::size_t parts, Parts& out) const;

  const BinaryTree& tree_;
  std::vector<std::array<float, 3>> cost_;               // [node][k - 1]: as at most k parts
  std::vector<std::array<std::uint8_t, 3>> left_parts_;  // how many of those are the left child's; 0: one part
                                                         // [0]: how many of a node's four children; 0: a leaf
};

}  // namespace castray
