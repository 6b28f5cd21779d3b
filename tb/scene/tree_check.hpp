// SPDX-License-Identifier: Apache-2.0
// Walks the whole hierarchy of an image and checks what the core and the model rely on.
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "mem/image.hpp"
#include "scene/bvh.hpp"
#include "scene/compile.hpp"
#include "scene/node.hpp"

namespace castray::tb {

class TreeCheck {
 public:
  explicit TreeCheck(const SceneImage& image)
      : image_(image), node_seen_(image.header.nodes.count), leaf_seen_(image.header.lines.count) {}

  void run() {
    EXPECT_EQ(image_.header.root, ref_word(RefNode, 0));
    ASSERT_GE(node_seen_.size(), 1u);
    subtree(0, 1);
    EXPECT_LE(depth, Bvh::kLevels);
    EXPECT_EQ(std::ranges::count(node_seen_, 1), std::ssize(node_seen_)) << "a node is not met exactly once";
    EXPECT_EQ(std::ranges::count(leaf_seen_, 1), std::ssize(leaf_seen_)) << "a leaf is not met exactly once";
    for (const auto& [number, times] : seen) EXPECT_EQ(times, 1) << "primitive " << number;
    EXPECT_EQ(seen.size() + image_.dropped_triangles + image_.dropped_spheres, image_.header.primitives);
  }

  unsigned depth = 0;
  std::map<std::uint64_t, int> seen;  // how often each primitive

 private:
  // The padded boxes of all primitives below.
  Box subtree(std::uint64_t index, unsigned level) {
    depth = std::max(depth, level);
    if (++node_seen_[index] > 1) return {};
    const node_t node = load_node(image_.bytes.data(), image_.header, index);
    check_form(node, index);
    Box all;
    for (const NodeChild& child : node_children(node)) {
      const Box below = contents(child.word, index, level);
      EXPECT_TRUE(child.box.holds(below)) << "node " << index;
      all.add(below);
    }
    return all;
  }

  Box contents(std::uint64_t word, std::uint64_t parent, unsigned level) {
    const std::uint64_t index = ref_index(word);
    if (ref_kind(word) == RefNode) {
      EXPECT_GT(index, parent);
      EXPECT_LT(index, node_seen_.size());
      return index > parent && index < node_seen_.size() ? subtree(index, level + 1) : Box();
    }
    EXPECT_EQ(word, ref_word(RefLeaf, index));
    EXPECT_LT(index, leaf_seen_.size());
    if (index >= leaf_seen_.size()) return {};
    ++leaf_seen_[index];
    EXPECT_LT(number_in(2 * index), number_in(2 * index + 1)) << "leaf " << index << " is not in order, or its first slot is empty";
    Box box;
    for (std::uint64_t slot = 2 * index; slot < 2 * index + 2; ++slot) {
      const prim_slot_t primitive = load_slot(image_.bytes.data(), image_.header, slot);
      if (primitive.number == std::uint64_t{NoPrim}) continue;
      ++seen[primitive.number];
      box.add(padded_box(primitive));
    }
    return box;
  }

  std::uint64_t number_in(std::uint64_t slot) const { return load_slot(image_.bytes.data(), image_.header, slot).number; }

  // Children from 0 up, the rest zero; the finest grid.
  void check_form(node_t node, std::uint64_t index) {
    const std::vector<NodeChild> children = node_children(node);
    EXPECT_GE(children.size(), index == 0 ? 1u : 2u);
    NodeFields fields(node);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint64_t least = 255, most = 0;
      for (std::size_t i = 0; i < children.size(); ++i) {
        EXPECT_LT(*fields.planes[i].low[axis], *fields.planes[i].high[axis]) << "node " << index;
        least = std::min(least, *fields.planes[i].low[axis]);
        most = std::max(most, *fields.planes[i].high[axis]);
      }
      EXPECT_EQ(least, 0u) << "node " << index;
      EXPECT_TRUE(most >= 128 || *fields.exp[axis] == 0) << "a finer grid would do, node " << index;
      EXPECT_LE(*fields.exp[axis], std::uint64_t{MaxPlaneExp});
    }
    for (std::size_t i = children.size(); i < 4; ++i) {
      EXPECT_EQ(*fields.ref[i], 0u);
      EXPECT_EQ(*fields.planes[i].high[0], 0u);
    }
    const auto bytes = image_.bytes.begin() + static_cast<std::ptrdiff_t>(image_.header.nodes.offset + index * NodeBytes);
    const auto packed = pack(node);
    EXPECT_EQ(std::memcmp(&*bytes, packed.data(), NodeBytes), 0) << "reserved bits are set";
  }

  const SceneImage& image_;
  std::vector<int> node_seen_, leaf_seen_;
};

inline void check_tree(const SceneImage& image) { TreeCheck(image).run(); }

}  // namespace castray::tb
