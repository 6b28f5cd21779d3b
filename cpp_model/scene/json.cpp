// SPDX-License-Identifier: Apache-2.0
#include "scene/json.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "scene/text.hpp"

namespace castray {

double JsonValue::number(const Limits& limits) const {
  const double x = number();
  if (!limits.hold(x)) fail(text_of(x) + " is not " + text_of(limits));
  return x;
}

int JsonValue::whole(const Limits& limits) const {
  const double x = number();
  if (x != std::floor(x)) fail(text_of(x) + " is not a whole number");
  return static_cast<int>(number(limits));
}

namespace {

// Watches the parser: of two equal keys in one object the library would silently take the later.
class TwiceGivenKeys {
 public:
  explicit TwiceGivenKeys(const std::string& file) : file_(file) {}

  void operator()(nlohmann::json::parse_event_t event, const nlohmann::json& value) {
    if (event == nlohmann::json::parse_event_t::object_start) open_.emplace_back();
    if (event == nlohmann::json::parse_event_t::object_end) open_.pop_back();
    if (event != nlohmann::json::parse_event_t::key) return;
    if (const auto& key = value.get_ref<const std::string&>(); !open_.back().insert(key).second)
      throw SceneError(file_, "key \"" + one_line(key) + "\"", "stands twice in one object");
  }

 private:
  const std::string& file_;
  std::vector<std::set<std::string>> open_;  // the keys so far of each object that is not closed
};

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& file) {
  try {
    return nlohmann::json::parse(text, [keys = TwiceGivenKeys(file)](int, auto event, auto& value) mutable {
      keys(event, value);
      return true;
    });
  } catch (const nlohmann::json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 3, column 7: syntax error while ..."
    // "[json.exception.out_of_range.406] number overflow parsing '1e999'"
    const std::string message = one_line(error.what());
    const std::size_t at = message.find("at line ");
    const std::size_t colon = at == std::string::npos ? at : message.find(": ", at);
    if (colon != std::string::npos) throw SceneError(file, message.substr(at + 3, colon - at - 3), message.substr(colon + 2));
    const std::size_t quote = message.find('\'');
    const std::size_t token = quote == std::string::npos ? 0 : text.find(message.substr(quote + 1, message.size() - quote - 2));
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(token, text.size())), '\n');
    throw SceneError(file, "line " + std::to_string(line), message.substr(message.find("] ") + 2));
  }
}

}  // namespace castray
