// SPDX-License-Identifier: Apache-2.0
#include "scene/stl_check.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "scene/scene.hpp"

namespace castray {

void check_stl(const std::string& bytes, const std::string& file) {
  constexpr std::size_t kHeader = 80, kFacet = 50;
  std::uint64_t facets = 0;
  if (bytes.size() >= kHeader + 4)
    for (std::size_t i = 0; i < 4; ++i) facets |= std::uint64_t{static_cast<std::uint8_t>(bytes[kHeader + i])} << 8 * i;
  if (bytes.size() == kHeader + 4 + facets * kFacet) return;  // binary, as assimp tells it
  std::string text = bytes;
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos || text.compare(first, 5, "solid") != 0) return;
  const std::size_t end = text.rfind("endsolid");  // with the solid's name, which may be any, behind it
  if (end == text.npos || text.find("facet normal", text.find_first_of("\r\n", end)) != text.npos)
    throw SceneError(file, "line " + std::to_string(1 + std::ranges::count(text, '\n')), "the file is truncated: it ends without endsolid");
}

}  // namespace castray
