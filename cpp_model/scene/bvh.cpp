// SPDX-License-Identifier: Apache-2.0
#include "scene/bvh.hpp"

#include "scene/collapse.hpp"
#include "scene/node.hpp"

namespace castray {
namespace {

class Builder {
 public:
  explicit Builder(const BinaryTree& tree) : tree_(tree), collapse_(tree) {}

  Bvh build() {
    add_node(0, Bvh::kLevels);
    return std::move(bvh_);
  }

 private:
  // In depth-first order: what lies below a node is together. `levels`: of nodes, this one's among them.
  std::uint64_t add_node(std::uint32_t at, std::uint32_t levels) {
    const std::size_t index = bvh_.nodes.size();
    bvh_.nodes.emplace_back();
    const Parts parts = children(at, levels);
    std::array<NodeChild, 4> children;
    for (std::size_t i = 0; i < parts.count; ++i) {
      const std::uint32_t part = parts.node[i];
      children[i] = {tree_[part].box, collapse_.is_leaf(part) ? add_leaf(part) : add_node(part, levels - 1)};
    }
    bvh_.nodes[index] = make_node({children.data(), parts.count});
    return ref_word(RefNode, index);
  }

  // The best children, or all grandchildren where one of those would be too high for the levels left:
  // a subtree of 2n binary levels always fits n levels.
  Parts children(std::uint32_t at, std::uint32_t levels) const {
    const BinaryNode& node = tree_[at];
    Parts best;
    if (collapse_.is_leaf(at)) return best.add(at), best;  // the root: the only leaf of its scene
    best = collapse_.children(at);
    bool fits = true;
    for (std::size_t i = 0; i < best.count; ++i) fits &= tree_[best.node[i]].height <= 2 * (levels - 1);
    if (fits) return best;
    Parts even;
    for (const std::uint32_t child : {node.left, node.right}) {
      if (tree_[child].leaf()) even.add(child);
      else even.add(tree_[child].left), even.add(tree_[child].right);
    }
    return even;
  }

  std::uint64_t add_leaf(std::uint32_t at) {
    const BinaryNode& node = tree_[at];
    std::array<std::uint32_t, 2> leaf = {node.left, Bvh::kNone};
    if (!node.leaf()) leaf = {tree_[node.left].left, tree_[node.right].left};
    if (leaf[1] < leaf[0]) std::swap(leaf[0], leaf[1]);
    bvh_.leaves.push_back(leaf);
    return ref_word(RefLeaf, bvh_.leaves.size() - 1);
  }

  const BinaryTree& tree_;
  Collapse collapse_;
  Bvh bvh_;
};

}  // namespace

Bvh build_bvh(const BinaryTree& tree) { return Builder(tree).build(); }

Bvh build_bvh(const std::vector<Box>& boxes) {
  BinaryTree tree = binary_tree(boxes);
  limit_height(tree, 2 * Bvh::kLevels);
  return build_bvh(tree);
}

}  // namespace castray
