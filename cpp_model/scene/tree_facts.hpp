// SPDX-License-Identifier: Apache-2.0
// What a scene image's hierarchy looks like.
#pragma once
#include <cstdint>

#include "scene/compile.hpp"

namespace castray {

struct TreeFacts {
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;
  unsigned depth = 0;       // nodes from the root to the deepest one
  double children = 0;      // of a node, on average
  double occupancy = 0;     // primitives of a leaf, on average
  // By the surface area heuristic: of a line that meets the scene's box.
  double nodes_met = 0;
  double leaves_met = 0;
  double tests_met = 0;
};

TreeFacts tree_facts(const SceneImage& image);

}  // namespace castray
