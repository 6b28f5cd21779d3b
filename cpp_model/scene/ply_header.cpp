// SPDX-License-Identifier: Apache-2.0
#include "scene/ply_header.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "scene/scene.hpp"

namespace castray {

void check_ply_header(const std::string& bytes, const std::string& file) {
  if (!bytes.starts_with("ply")) return;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;  // more than any file: sums cannot overflow
  std::uint64_t elements = 0;
  int number = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n", at), bytes.size());
    ++number;
    std::istringstream line(bytes.substr(at, end - at));
    at = end + (bytes.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    std::string word, name, count;
    line >> word;
    if (word == "end_header") {
      const std::size_t left = bytes.size() - std::min(at, bytes.size());
      if (elements > left)
        throw SceneError(file, "header", std::to_string(elements) + " elements are announced, " + std::to_string(left) + " bytes follow");
      return;
    }
    if (word != "element") continue;
    line >> name >> count;
    std::uint64_t value = 0;
    const auto read = std::from_chars(count.data(), count.data() + count.size(), value);
    if (read.ec != std::errc() || read.ptr != count.data() + count.size() || value > kMost || elements > kMost)
      throw SceneError(file, "line " + std::to_string(number), "'" + count + "' is not a number of elements");
    elements += value;
  }
  throw SceneError(file, "header", "has no end_header");
}

}  // namespace castray
