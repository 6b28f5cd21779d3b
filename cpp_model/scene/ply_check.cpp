// SPDX-License-Identifier: Apache-2.0
#include "scene/ply_check.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace castray {
namespace {

// Bytes of a scalar in the binary formats.
std::optional<std::size_t> size_of(std::string_view type) {
  constexpr std::string_view kTypes[4][6] = {{"char", "uchar", "int8", "uint8"},
                                             {"short", "ushort", "int16", "uint16"},
                                             {"int", "uint", "int32", "uint32", "float", "float32"},
                                             {"double", "float64"}};
  for (std::size_t i = 0; i < std::size(kTypes); ++i)
    if (std::ranges::find(kTypes[i], type) != std::end(kTypes[i])) return std::size_t{1} << i;
  return std::nullopt;
}

struct Property {
  std::size_t bytes;        // of the scalar, of an entry of the list
  std::size_t count_bytes;  // of the list's length; 0: no list
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;
};

// Goes through what follows the header as it says. A list's length that is no number is left to assimp.
class Body {
 public:
  Body(std::string_view bytes, const std::string& file) : left_(bytes), file_(file) {}

  void check(const std::vector<Element>& elements, const std::string& format) {
    for (const Element& element : elements)
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) {
          std::int64_t entries = 1;
          bool there = true;
          if (property.count_bytes != 0) {
            std::optional<std::int64_t> length;
            there = format == "ascii" ? token(length) : whole(property.count_bytes, format == "binary_big_endian", length);
            if (there && !length) return;
            entries = length.value_or(0);
          }
          if (entries < 0) throw SceneError(file_, element.name + " " + std::to_string(i), "a list of " + std::to_string(entries) + " entries");
          there = there && (format == "ascii" ? skip_tokens(entries) : skip_bytes(static_cast<std::uint64_t>(entries), property.bytes));
          if (!there) throw SceneError(file_, element.name + " " + std::to_string(i), "the file is truncated: it ends here");
        }
  }

 private:
  static constexpr std::string_view kSpace = " \t\r\n";

  // The next word that does not stand in a comment; empty at the end.
  std::string_view word() {
    for (;;) {
      left_.remove_prefix(std::min(left_.find_first_not_of(kSpace), left_.size()));
      const std::string_view found = left_.substr(0, left_.find_first_of(kSpace));
      if (found != "comment") return found;
      left_.remove_prefix(std::min(left_.find_first_of("\r\n"), left_.size()));
    }
  }
  bool token(std::optional<std::int64_t>& value) {
    const std::string_view text = word();
    if (text.empty()) return false;
    left_.remove_prefix(text.size());
    std::int64_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec == std::errc() && read.ptr == text.data() + text.size()) value = number;
    return true;
  }
  bool skip_tokens(std::int64_t count) {
    for (; count > 0; --count) {
      const std::string_view text = word();
      if (text.empty()) return false;
      left_.remove_prefix(text.size());
    }
    return true;
  }
  bool whole(std::size_t bytes, bool big_endian, std::optional<std::int64_t>& value) {
    if (left_.size() < bytes) return false;
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bytes; ++i)
      number |= std::uint64_t{static_cast<std::uint8_t>(left_[i])} << 8 * (big_endian ? bytes - 1 - i : i);
    left_.remove_prefix(bytes);
    value = static_cast<std::int64_t>(number);
    return true;
  }
  bool skip_bytes(std::uint64_t count, std::size_t bytes) {
    if (count > left_.size() / bytes) return false;
    left_.remove_prefix(count * bytes);
    return true;
  }

  std::string_view left_;
  const std::string& file_;
};

}  // namespace

void check_ply(const std::string& bytes, const std::string& file) {
  if (!bytes.starts_with("ply")) return;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;  // more than any file: sums cannot overflow
  std::uint64_t announced = 0;
  std::vector<Element> elements;
  std::string format;
  bool known = true;  // every type of a property
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
      if (announced > left)
        throw SceneError(file, "header", std::to_string(announced) + " elements are announced, " + std::to_string(left) + " bytes follow");
      if (known) Body(std::string_view(bytes).substr(bytes.size() - left), file).check(elements, format);
      return;
    }
    if (word == "format") line >> format;
    if (word == "property") {
      std::string type, length;
      line >> type;
      const bool list = type == "list";
      if (list) line >> length >> type;
      const auto bytes_of_length = list ? size_of(length) : std::size_t{0}, bytes_of_entry = size_of(type);
      known = known && bytes_of_length && bytes_of_entry && !elements.empty();
      if (known) elements.back().properties.push_back({*bytes_of_entry, *bytes_of_length});
    }
    if (word != "element") continue;
    line >> name >> count;
    std::uint64_t value = 0;
    const auto read = std::from_chars(count.data(), count.data() + count.size(), value);
    if (read.ec != std::errc() || read.ptr != count.data() + count.size() || value > kMost || announced > kMost)
      throw SceneError(file, "line " + std::to_string(number), "'" + count + "' is not a number of elements");
    announced += value;
    elements.push_back({name, value, {}});
  }
  throw SceneError(file, "header", "has no end_header");
}

}  // namespace castray
