// SPDX-License-Identifier: Apache-2.0
// The hierarchy of a scene image: nodes of four children with planes of 8 bits, leaves of at most two
// primitives. docs/scene-image.md has its records, docs/hierarchy.md how it is built.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "castray_records.hpp"
#include "scene/binary_tree.hpp"

namespace castray {

struct Bvh {
  static constexpr std::uint32_t kLevels = MaxLevels;  // nodes from the root to the deepest one, at most
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<node_t> nodes;                        // node 0 is the root
  std::vector<std::array<std::uint32_t, 2>> leaves;  // the numbers of their boxes, kNone for no second
};

// boxes: of each primitive, padded, at least one; within the range of coordinates.
Bvh build_bvh(const std::vector<Box>& boxes);

// The same of a binary tree of at most 2 x kLevels levels.
Bvh build_bvh(const BinaryTree& tree);

}  // namespace castray
