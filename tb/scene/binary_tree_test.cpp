// SPDX-License-Identifier: Apache-2.0
// The binary tree: complete, its boxes exact, its height limited; and its collapse into four
// children, on trees as high as may be.
#include "scene/binary_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "scene/bvh.hpp"
#include "scene/collapse.hpp"
#include "scene/node.hpp"

namespace castray {
namespace {

std::vector<Box> random_boxes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const auto at = [&](std::int64_t limit) { return static_cast<std::int64_t>(random()) % limit; };
    const std::int64_t size = std::int64_t{1} << (random() % 20);
    box.add({at(60'000'000), at(60'000'000), at(60'000'000)});
    box.add({box.low[0] + at(size), box.low[1] + at(size), box.low[2] + at(size)});
  }
  return boxes;
}

// A chain: each node has a leaf on the left, and the rest on the right.
BinaryTree chain(const std::vector<Box>& boxes) {
  BinaryTree tree(2 * boxes.size() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t leaf = i + 1 < boxes.size() ? 2 * i + 1 : 2 * i;
    tree[leaf].box = boxes[i];
    tree[leaf].left = i;
    if (i + 1 < boxes.size()) tree[2 * i].left = leaf, tree[2 * i].right = 2 * i + 2;
  }
  complete(tree);
  return tree;
}

void check(const BinaryTree& tree, const std::vector<Box>& boxes) {
  std::multiset<std::uint32_t> found;
  for (std::size_t at = 0; at < tree.size(); ++at) {
    const BinaryNode& node = tree[at];
    if (node.leaf()) {
      found.insert(node.left);
      EXPECT_EQ(node.box, boxes[node.left]);
      EXPECT_EQ(node.height, 0u);
      continue;
    }
    ASSERT_GT(node.left, at);
    ASSERT_GT(node.right, at);
    Box both = tree[node.left].box;
    both.add(tree[node.right].box);
    EXPECT_EQ(node.box, both);
    EXPECT_EQ(node.count, tree[node.left].count + tree[node.right].count);
    EXPECT_EQ(node.height, 1 + std::max(tree[node.left].height, tree[node.right].height));
  }
  EXPECT_EQ(tree[0].count, boxes.size());
  EXPECT_EQ(tree.size(), 2 * boxes.size() - 1);
  ASSERT_EQ(found.size(), boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(found.count(i), 1u);
}

TEST(BinaryTree, HoldsEveryBoxOnce) {
  for (const std::size_t count : {1, 2, 3, 4, 5, 100, 5000}) {
    const std::vector<Box> boxes = random_boxes(count, static_cast<unsigned>(count));
    check(binary_tree(boxes), boxes);
  }
}

TEST(BinaryTree, ParentsOfNearBoxesAreSmall) {
  // Eight clusters of eight: the heuristic finds them.
  std::vector<Box> boxes(64);
  for (std::size_t i = 0; i < 64; ++i) {
    const auto at = [&](std::size_t bit) { return static_cast<std::int64_t>((i >> bit & 1) * 1'000'000 + (i >> (bit + 3) & 1) * 100); };
    boxes[i].add({at(0), at(1), at(2)});
    boxes[i].pad(10);
  }
  const BinaryTree tree = binary_tree(boxes);
  for (const BinaryNode& node : tree)
    if (node.count <= 8) EXPECT_LE(node.box.high[0] - node.box.low[0], 120);
}

// ---- Height ----

TEST(BinaryTree, HeightStaysWhereItIsWithinTheLimit) {
  const std::vector<Box> boxes = random_boxes(1000, 7);
  BinaryTree tree = binary_tree(boxes);
  const BinaryTree before = tree;
  limit_height(tree, tree[0].height);
  for (std::size_t i = 0; i < tree.size(); ++i) EXPECT_EQ(tree[i].left, before[i].left);
}

TEST(BinaryTree, HeightOfAChainIsLimited) {
  for (const std::uint32_t most : {10u, 11u, 20u, 64u}) {
    const std::vector<Box> boxes = random_boxes(1024, most);
    BinaryTree tree = chain(boxes);
    EXPECT_EQ(tree[0].height, 1023u);
    limit_height(tree, most);
    EXPECT_LE(tree[0].height, most);
    check(tree, boxes);
    // Near the root the chain may stay as it was: only what does not fit is divided evenly.
    if (most == 64) EXPECT_TRUE(tree[tree[tree[0].right].right].height + 2 == tree[0].height && tree[tree[0].left].leaf());
  }
}

// ---- Collapse ----

// Levels of four-child nodes, with children as Collapse gives them.
std::uint32_t levels(const BinaryTree& tree, const Collapse& collapse, std::uint32_t at, std::set<std::uint32_t>& leaves) {
  if (collapse.is_leaf(at)) {
    EXPECT_LE(tree[at].count, 2u);
    leaves.insert(at);
    return 0;
  }
  const Parts parts = collapse.children(at);
  EXPECT_GE(parts.count, 2u);
  EXPECT_LE(parts.count, 4u);
  std::uint32_t most = 0, count = 0;
  for (std::size_t i = 0; i < parts.count; ++i) {
    most = std::max(most, levels(tree, collapse, parts.node[i], leaves));
    count += tree[parts.node[i]].count;
  }
  EXPECT_EQ(count, tree[at].count);
  return most + 1;
}

TEST(Collapse, KeepsEveryBox) {
  for (const std::size_t count : {2, 3, 4, 5, 6, 7, 8, 9, 1000}) {
    const BinaryTree tree = binary_tree(random_boxes(count, 9));
    const Collapse collapse(tree);
    std::set<std::uint32_t> leaves;
    EXPECT_LE(levels(tree, collapse, 0, leaves), tree[0].height);
    std::size_t held = 0;
    for (const std::uint32_t leaf : leaves) held += tree[leaf].count;
    EXPECT_EQ(held, count);
  }
}

// Three small boxes across the whole at each level of a chain whose rest shrinks: best is to open the
// three, so that a node takes one level of the chain only. Where that is too high it takes two.
TEST(Collapse, OfTheHighestTreeFitsTheLevels) {
  constexpr std::uint32_t kHeight = 2 * Bvh::kLevels;
  std::vector<Box> boxes;
  BinaryTree tree;
  const auto leaf = [&](std::int64_t x, std::int64_t y) {
    Box& box = boxes.emplace_back();
    box.add({x, y, 0});
    box.pad(1);
    tree.push_back({.box = box, .left = static_cast<std::uint32_t>(boxes.size() - 1)});
  };
  for (std::uint32_t level = 0; level + 2 < kHeight; ++level) {
    const auto size = static_cast<std::int64_t>(std::exp2(26 - level * 0.35));
    const auto at = static_cast<std::uint32_t>(tree.size());
    tree.push_back({.left = at + 1, .right = at + 6});
    tree.push_back({.left = at + 2, .right = at + 5});
    tree.push_back({.left = at + 3, .right = at + 4});
    leaf(0, 0);
    leaf(size, 0);
    leaf(0, size);
  }
  leaf(0, 0);
  complete(tree);
  ASSERT_EQ(tree[0].height, kHeight);
  std::set<std::uint32_t> leaves;
  EXPECT_GT(levels(tree, Collapse(tree), 0, leaves), Bvh::kLevels) << "the tree is no case of the rule";

  const Bvh bvh = build_bvh(tree);
  std::vector<unsigned> depth(bvh.nodes.size(), 1);
  std::set<std::uint32_t> found;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    EXPECT_LE(depth[i], Bvh::kLevels);
    for (const NodeChild& child : node_children(bvh.nodes[i]))
      if (ref_kind(child.word) == RefNode) depth[ref_index(child.word)] = depth[i] + 1;
  }
  for (const auto& leaf : bvh.leaves) found.insert(leaf.begin(), leaf.end());
  found.erase(Bvh::kNone);
  EXPECT_EQ(found.size(), boxes.size());
}

// Four far apart, of one size: one node of four leaves, whatever the binary tree was.
TEST(Collapse, OfFourApartIsOneNode) {
  std::vector<Box> boxes(4);
  for (std::int64_t i = 0; i < 4; ++i) boxes[std::size_t(i)].add({1000 * i, 0, 0}), boxes[std::size_t(i)].pad(10);
  for (const BinaryTree& tree : {binary_tree(boxes), chain(boxes)}) {
    const Collapse collapse(tree);
    EXPECT_EQ(collapse.children(0).count, 4u);
    for (const std::uint32_t part : collapse.children(0).node) EXPECT_TRUE(collapse.is_leaf(part));
  }
}

// Two that lie in one place are a leaf, two that lie apart are not.
TEST(Collapse, PairsWhatIsTogether) {
  std::vector<Box> boxes(4);
  for (std::size_t i = 0; i < 4; ++i) boxes[i].add({i < 2 ? 0 : i == 2 ? 5000 : 90000, 0, 0}), boxes[i].pad(10);
  const BinaryTree tree = binary_tree(boxes);
  const Collapse collapse(tree);
  const Parts parts = collapse.children(0);
  EXPECT_EQ(parts.count, 3u);
  for (std::size_t i = 0; i < parts.count; ++i) EXPECT_EQ(tree[parts.node[i]].count, tree[parts.node[i]].box.high[0] == 10 ? 2u : 1u);
}

}  // namespace
}  // namespace castray
