// SPDX-License-Identifier: Apache-2.0
// The items of a ray's stages as lines of name and value.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "fixed.hpp"
#include "traverse/lane.hpp"

namespace castray::cli {

struct Field {
  std::string name;
  std::string value;
};
using Fields = std::vector<Field>;

// A record's fields one by one; those of a stream that numbers places, not values, are left out.
template <class Record> Fields fields(const Record& record) {
  Fields list;
  record.each_field([&](std::string_view name, const auto& value, int, int, bool is_signed) {
    if (name == "tag.slot" || name == "ctx" || name == "hit.tag.slot") return;
    if constexpr (requires { static_cast<std::uint64_t>(value); })
      list.push_back({std::string(name), is_signed ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(static_cast<std::uint64_t>(value))});
  });
  return list;
}

// "node 12"; a node of a tile's frontier is "tile node 0".
inline std::string text_of(const ref_t& ref) {
  constexpr std::array<const char*, 4> kinds{"nothing", "node ", "leaf ", "tile node "};
  return kinds[ref.kind & 3] + (ref.kind == static_cast<std::uint64_t>(RefNone) ? "" : std::to_string(ref.index));
}
inline ref_t ref_of(ref_word_t word) {
  return {.index = word & ((std::uint64_t{1} << LineW) - 1), .kind = word >> LineW & 3};
}

inline Fields fields(const Visit& visit) {
  Fields list{{"goes to", text_of(visit.target)}};
  for (const entry_t* child : {&visit.children.e0, &visit.children.e1, &visit.children.e2, &visit.children.e3})
    if (child->target.kind != static_cast<std::uint64_t>(RefNone))
      list.push_back({"  meets", text_of(child->target) + ", least " + std::to_string(child->least)});
  return list;
}

inline Fields fields(line_t node) { return {{"node", std::to_string(node)}}; }

inline Fields fields(const started_t& started) {
  constexpr std::array<const char*, 4> starts{"nowhere: empty", "the root", "one node", "two nodes"};
  const tile_t& tile = started.tile;
  const auto pair = [](std::uint64_t a, const char* between, std::uint64_t b) { return std::to_string(a) + between + std::to_string(b); };
  return {{"tile", pair(tile.width, "x", tile.height) + " at " + pair(tile.x, ", ", tile.y)}, {"its rays start at", starts[started.start & 3]}};
}

// Of a node what its children are, and their boxes.
inline Fields fields(const node_t& node) {
  const auto three = [](std::uint64_t x, std::uint64_t y, std::uint64_t z) { return std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z); };
  Fields list{{"corner", three(node.x, node.y, node.z)}, {"spacing, log2", three(node.exp_x, node.exp_y, node.exp_z)}};
  const std::array<ref_word_t, 4> words{node.ref0, node.ref1, node.ref2, node.ref3};
  const std::array<const child_box_t*, 4> boxes{&node.box0, &node.box1, &node.box2, &node.box3};
  for (std::size_t i = 0; i < words.size() && words[i] != 0; ++i) {
    list.push_back({"child", text_of(ref_of(words[i]))});
    list.push_back({"  low planes", three(boxes[i]->x0, boxes[i]->y0, boxes[i]->z0)});
    list.push_back({"  high planes", three(boxes[i]->x1, boxes[i]->y1, boxes[i]->z1)});
  }
  return list;
}

}  // namespace castray::cli
