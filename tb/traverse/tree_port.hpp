// SPDX-License-Identifier: Apache-2.0
// The hierarchy of a scene image as the RTL is told of it, and as it reads it.
#pragma once
#include <cstring>

#include "dut.hpp"
#include "scene/compile.hpp"
#include "traverse/lane.hpp"

namespace castray::tb {

inline tree_t tree_port(const Tree& tree) {
  tree_t t;
  t.node_base = tree.header->nodes.offset / LineBytes, t.node_count = tree.header->nodes.count;
  t.leaf_base = tree.header->lines.offset / LineBytes, t.leaf_count = tree.header->lines.count;
  t.primitives = tree.header->primitives, t.limit = tree.limit;
  return t;
}

inline line_data_t line_at(const SceneImage& image, line_no_t line) {
  line_data_t data{};
  const std::size_t at = std::size_t{line} * LineBytes;
  if (at + LineBytes > image.bytes.size()) ADD_FAILURE() << "line " << line << " lies outside the image";
  else std::memcpy(data.data(), &image.bytes[at], LineBytes);
  return data;
}

}  // namespace castray::tb
