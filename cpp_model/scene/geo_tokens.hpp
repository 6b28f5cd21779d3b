// SPDX-License-Identifier: Apache-2.0
// Numbers separated by white space, each read at a named place.
#pragma once
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "scene/scene.hpp"
#include "scene/text.hpp"

namespace castray {

class GeoTokens {
 public:
  static constexpr std::size_t kOnly = -1;  // a place that needs no number

  GeoTokens(const std::string& text, const std::string& file) : at_(text.data()), end_(at_ + text.size()), file_(file) {
    bool inside = false;
    for (const char* c = at_; c != end_; ++c) {
      left_ += !is_space(*c) && !inside;
      inside = !is_space(*c);
    }
  }

  std::size_t left() const { return left_; }

  // Throws unless `needed` numbers are left.
  void expect(std::size_t needed, const std::string& what) const {
    if (left_ < needed)
      throw SceneError(file_, what, "the file ends after " + std::to_string(left_) + " of " + std::to_string(needed) + " values");
  }

  // The next number; what and number are its place, "face 3".
  double real(const char* what, std::size_t number) {
    const std::string_view token = next();
    double value = 0;
    const std::errc error = read(token, value);
    if (error == std::errc::result_out_of_range) fail(what, number, "'" + shown(token) + "' is outside the number range");
    if (error != std::errc()) fail(what, number, "'" + shown(token) + "' is not a number");
    if (!std::isfinite(value)) fail(what, number, "'" + shown(token) + "' is not a finite number");
    return value;
  }

  // The same, for a whole number from least to most.
  std::size_t whole(const char* what, std::size_t number, long long least, long long most) {
    const std::string_view token = next();
    long long value = 0;
    const std::errc error = read(token, value);
    if (error != std::errc() && error != std::errc::result_out_of_range) fail(what, number, "'" + shown(token) + "' is not a whole number");
    if (error != std::errc() || value < least || value > most)
      fail(what, number, shown(token) + " is not between " + std::to_string(least) + " and " + std::to_string(most));
    return static_cast<std::size_t>(value);
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static std::string shown(std::string_view token) {
    return one_line(std::string(token.substr(0, 24))) + (token.size() > 24 ? "..." : "");
  }

  template <class Number> static std::errc read(std::string_view token, Number& value) {
    const char* const end = token.data() + token.size();
    if (token.starts_with("+-")) return std::errc::invalid_argument;  // from_chars takes no plus of its own
    const auto result = std::from_chars(token.data() + (token[0] == '+'), end, value);
    return result.ec == std::errc() && result.ptr != end ? std::errc::invalid_argument : result.ec;
  }

  [[noreturn]] void fail(const char* what, std::size_t number, const std::string& cause) const {
    throw SceneError(file_, "line " + std::to_string(line_) + ", " + what + (number == kOnly ? "" : " " + std::to_string(number)), cause);
  }

  // The caller has made sure that there is one: see expect().
  std::string_view next() {
    for (; is_space(*at_); ++at_) line_ += *at_ == '\n';
    const char* const from = at_;
    while (at_ != end_ && !is_space(*at_)) ++at_;
    --left_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }

  const char* at_;
  const char* end_;
  const std::string& file_;
  std::size_t left_ = 0;
  int line_ = 1;
};

}  // namespace castray
