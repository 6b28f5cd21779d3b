// SPDX-License-Identifier: Apache-2.0
// Small text for messages and files.
#pragma once
#include <charconv>
#include <string>

#include "scene/limits.hpp"

namespace castray {

// The shortest text that reads back as the same number.
inline std::string text_of(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x);
  return std::string(buffer, end.ptr);
}

// "between 1 and 4096".
inline std::string text_of(const Limits& limits) { return "between " + text_of(limits.least) + " and " + text_of(limits.most); }

// "1 triangle", "2 triangles".
inline std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

// Control characters become spaces, so that a message stays one line.
inline std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace castray
