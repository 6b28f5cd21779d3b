// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_check.hpp"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace castray {
namespace {

constexpr std::size_t kDeepest = 1000;  // brackets in brackets, nodes below nodes

std::uint64_t word_at(std::string_view bytes, std::size_t at) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint64_t{static_cast<std::uint8_t>(bytes[at + i])} << 8 * i;
  return word;
}

// The JSON of a .glb: its first chunk.
std::string_view first_chunk(std::string_view bytes, const std::string& file) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  if (bytes.size() < kHeader + kChunkHeader) throw SceneError(file, "header", "the file is truncated: " + std::to_string(bytes.size()) + " bytes");
  const auto check = [&](std::uint64_t length, std::size_t left, const char* place) {
    if (length > left)
      throw SceneError(file, place, std::to_string(length) + " bytes are announced, " + std::to_string(left) + " are there: is the file truncated?");
  };
  check(word_at(bytes, 8), bytes.size(), "header");
  const std::uint64_t length = word_at(bytes, kHeader);
  check(length, bytes.size() - kHeader - kChunkHeader, "first chunk");
  return bytes.substr(kHeader + kChunkHeader, length);
}

void check_brackets(std::string_view text, const std::string& file) {
  std::size_t depth = 0;
  bool inside = false;  // a string
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inside && c == '\\') ++i;
    else if (c == '"') inside = !inside;
    else if (!inside && (c == '[' || c == '{')) ++depth;
    else if (!inside && (c == ']' || c == '}') && depth > 0) --depth;
    if (depth > kDeepest) throw SceneError(file, "byte " + std::to_string(i), "more than " + std::to_string(kDeepest) + " brackets in each other");
  }
}

void check_nodes(const nlohmann::json& json, const std::string& file) {
  if (!json.is_object() || !json.contains("nodes") || !json["nodes"].is_array()) return;
  const nlohmann::json& nodes = json["nodes"];
  std::vector<std::size_t> parent(nodes.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_object() || !nodes[i].contains("children") || !nodes[i]["children"].is_array()) continue;
    for (const nlohmann::json& child : nodes[i]["children"]) {
      if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size()) continue;
      const auto at = child.get<std::size_t>();
      if (parent[at] != nodes.size())
        throw SceneError(file, "node " + std::to_string(at), "is a child of the nodes " + std::to_string(parent[at]) + " and " + std::to_string(i) + ": nodes must be a tree");
      parent[at] = i;
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::size_t depth = 0;
    for (std::size_t at = i; at != nodes.size(); at = parent[at])
      if (++depth > kDeepest) throw SceneError(file, "node " + std::to_string(i), "has more than " + std::to_string(kDeepest) + " nodes above it");
  }
}

}  // namespace

void check_gltf(const std::string& bytes, const std::string& file) {
  const std::string_view text = bytes.starts_with("glTF") ? first_chunk(bytes, file) : std::string_view(bytes);
  check_brackets(text, file);
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded()) check_nodes(json, file);
}

}  // namespace castray
