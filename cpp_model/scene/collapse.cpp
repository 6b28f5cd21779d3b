// SPDX-License-Identifier: Apache-2.0
#include "scene/collapse.hpp"

#include <algorithm>
#include <limits>

namespace castray {
namespace {

// Fetching and testing a node, fetching a leaf, testing a primitive. Tests are cheap beside the memory
// that a half-filled line takes; the work of a ray changes little from 0.3 to 1.
constexpr float kNodeCost = 1, kLeafCost = 1, kTestCost = 0.5;

}  // namespace

Collapse::Collapse(const BinaryTree& tree) : tree_(tree), cost_(tree.size()), left_parts_(tree.size()) {
  for (std::size_t at = tree.size(); at-- > 0;) {
    const BinaryNode& node = tree[at];
    const float area = static_cast<float>(node.box.half_area());
    const float leaf = area * (kLeafCost + kTestCost * static_cast<float>(node.count));
    cost_[at].fill(leaf);
    if (node.leaf()) continue;
    std::array<float, 3> forest;  // as two, three and four parts
    std::array<std::uint8_t, 3> left_parts;
    for (std::size_t k = 2; k <= 4; ++k) {
      forest[k - 2] = std::numeric_limits<float>::infinity();
      for (std::size_t left = 1; left < k; ++left) {
        const std::size_t l = std::min(left, std::size_t{3}), r = std::min(k - left, std::size_t{3});
        const float sum = cost_[node.left][l - 1] + cost_[node.right][r - 1];
        if (sum < forest[k - 2]) forest[k - 2] = sum, left_parts[k - 2] = static_cast<std::uint8_t>(left);
      }
    }
    const float inner = area * kNodeCost + forest[2];
    if (node.count > 2 || inner < leaf) cost_[at].fill(inner), left_parts_[at][0] = left_parts[2];
    for (std::size_t k = 2; k <= 3; ++k)
      if (forest[k - 2] < cost_[at][0]) cost_[at][k - 1] = forest[k - 2], left_parts_[at][k - 1] = left_parts[k - 2];
  }
}

Parts Collapse::children(std::uint32_t node) const {
  Parts parts;
  const std::size_t left = left_parts_[node][0];
  divide(tree_[node].left, left, parts);
  divide(tree_[node].right, 4 - left, parts);
  return parts;
}

void Collapse::divide(std::uint32_t node, std::size_t parts, Parts& out) const {
  const std::size_t left = parts == 1 ? 0 : left_parts_[node][parts - 1];
  if (left == 0) return out.add(node);
  divide(tree_[node].left, left, out);
  divide(tree_[node].right, parts - left, out);
}

}  // namespace castray
