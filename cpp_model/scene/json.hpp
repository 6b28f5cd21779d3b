// SPDX-License-Identifier: Apache-2.0
// A value of a JSON file that knows its place, so that every complaint names it: "meshes[0].file".
#pragma once
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/limits.hpp"
#include "scene/scene.hpp"

namespace castray {

class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, const std::string& file, std::string place) : value_(value), file_(file), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& cause) const { throw SceneError(file_, place_.empty() ? "scene" : place_, cause); }

  // An object with no other keys than these.
  template <std::size_t N> void allow(const char* const (&keys)[N]) const {
    if (!value_.is_object()) fail("must be an object");
    for (const auto& item : value_.items())
      if (std::none_of(std::begin(keys), std::end(keys), [&](const char* known) { return item.key() == known; }))
        fail("unknown key \"" + item.key() + "\"");
  }
  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  bool is_array() const { return value_.is_array(); }
  bool is_string() const { return value_.is_string(); }
  bool is_number() const { return value_.is_number(); }

  JsonValue operator[](const char* key) const {
    if (!has(key)) fail(std::string("\"") + key + "\" is missing");
    return {value_[key], file_, place_.empty() ? key : place_ + "." + key};
  }

  std::vector<JsonValue> elements() const {
    if (!value_.is_array()) fail("must be a list");
    std::vector<JsonValue> elements;
    for (std::size_t i = 0; i < value_.size(); ++i) elements.emplace_back(value_[i], file_, place_ + "[" + std::to_string(i) + "]");
    return elements;
  }

  double number() const {
    if (!value_.is_number()) fail("must be a number");
    return value_.get<double>();
  }
  double number(const Limits& limits) const;  // and within these
  int whole(const Limits& limits) const;
  std::string text() const {
    if (!value_.is_string()) fail("must be a string");
    return value_.get<std::string>();
  }
  template <std::size_t N> std::array<double, N> numbers() const {
    std::array<double, N> numbers;
    const auto list = value_.is_array() ? elements() : std::vector<JsonValue>();
    if (list.size() != N) fail("must be a list of " + std::to_string(N) + " numbers");
    for (std::size_t i = 0; i < N; ++i) numbers[i] = list[i].number();
    return numbers;
  }
  Vec3 vec3() const {
    const auto xyz = numbers<3>();
    return {xyz[0], xyz[1], xyz[2]};
  }

 private:
  const nlohmann::json& value_;
  const std::string& file_;
  std::string place_;
};

// Throws SceneError with line and column when the text is not JSON.
nlohmann::json parse_json(const std::string& text, const std::string& file);

}  // namespace castray
