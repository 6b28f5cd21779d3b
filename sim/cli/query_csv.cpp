// SPDX-License-Identifier: Apache-2.0
#include "query_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "command.hpp"
#include "scene/mesh.hpp"
#include "scene/text.hpp"

namespace castray::cli {
namespace {

constexpr std::array<std::string_view, 11> kColumns{"ox", "oy", "oz", "dx", "dy", "dz", "tmin", "tmax", "any", "cull", "ignore"};
constexpr std::size_t kRequired = 6;  // the first ones
enum Column : std::size_t { kOrigin = 0, kDirection = 3, kTmin = 6, kTmax, kAny, kCull, kIgnore };

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  text = text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
  return text.size() >= 2 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

// A piece of the input in a message: short, and nothing in it that moves a cursor.
std::string quoted(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string word(text.substr(0, kMost));
  std::ranges::replace_if(word, [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + word + (text.size() > kMost ? "...'" : "'");
}

class Parser {
 public:
  Parser(const std::string& name, std::string_view text, std::size_t primitives) : name_(name), rest_(text), primitives_(primitives) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  }

  RayText rays() {
    if (!next_line()) fail("empty; its first line must name the columns ox,oy,oz,dx,dy,dz");
    header();
    RayText text;
    while (next_line()) {
      if (text.rays.size() == std::size_t{MaxRays}) fail("more than " + std::to_string(MaxRays) + " rays");
      text.rays.push_back(ray());
      text.lines.push_back(line_);
    }
    if (text.rays.empty()) fail("no rays below the columns' names");
    return text;
  }

 private:
  std::string place() const { return name_ + ":" + std::to_string(std::max<std::size_t>(line_, 1)); }
  [[noreturn]] void fail(const std::string& cause) const { throw InputError(place() + ": " + cause); }
  [[noreturn]] void fail(std::size_t column, const std::string& cause) const { fail(std::string(kColumns[column]) + ": " + cause); }

  // The fields of the next line that is neither blank nor a comment.
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_;
      const std::size_t first = line.find_first_not_of(kBlanks);
      if (first == line.npos || line[first] == '#') continue;
      fields_.clear();
      for (std::size_t comma; (comma = line.find(',')) != line.npos; line.remove_prefix(comma + 1)) fields_.push_back(trimmed(line.substr(0, comma)));
      fields_.push_back(trimmed(line));
      return true;
    }
    return false;
  }

  void header() {
    for (const std::string_view field : fields_) {
      const auto column = static_cast<std::size_t>(std::ranges::find(kColumns, field) - kColumns.begin());
      if (column == kColumns.size()) fail(quoted(field) + " is no column; there are ox,oy,oz,dx,dy,dz, and if wanted tmin,tmax,any,cull,ignore");
      if (std::ranges::find(columns_, column) != columns_.end()) fail("column " + quoted(field) + " stands twice");
      columns_.push_back(column);
    }
    for (std::size_t column = 0; column < kRequired; ++column)
      if (std::ranges::find(columns_, column) == columns_.end()) fail("column '" + std::string(kColumns[column]) + "' is missing");
  }

  ListRay ray() const {
    if (fields_.size() != columns_.size())
      fail(counted(fields_.size(), "field") + ", the first line names " + counted(columns_.size(), "column"));
    ListRay ray;
    for (std::size_t i = 0; i < fields_.size(); ++i) set(ray, columns_[i], fields_[i]);
    if (ray.direction == Vec3(0)) fail("the direction is zero");
    if (std::max(ray.tmin, 0.0) >= ray.tmax) fail("empty range: tmin " + castray::text_of(ray.tmin) + ", tmax " + castray::text_of(ray.tmax));
    return ray;
  }

  void set(ListRay& ray, std::size_t column, std::string_view field) const {
    if (field.empty()) {
      if (column < kRequired) fail(column, "empty");
      return;  // as by default
    }
    switch (column) {
      case kTmin: ray.tmin = finite(column, field); break;
      case kTmax: ray.tmax = number(column, field); break;
      case kAny: ray.any = flag(column, field); break;
      case kCull: ray.cull = flag(column, field); break;
      case kIgnore: ray.ignore = primitive(field); break;
      default:
        if (column < kDirection) ray.origin[static_cast<int>(column)] = coordinate(column, field);
        else ray.direction[static_cast<int>(column - kDirection)] = finite(column, field);
    }
  }

  double number(std::size_t column, std::string_view field) const {
    const bool plus = field.size() > 1 && field[0] == '+' && field[1] != '-';
    double x = 0;
    const auto [end, error] = std::from_chars(field.data() + plus, field.data() + field.size(), x);
    if (error == std::errc::invalid_argument || end != field.data() + field.size() || std::isnan(x)) fail(column, quoted(field) + " is not a number");
    if (error != std::errc()) fail(column, quoted(field) + " is beyond what a double holds");
    return x;
  }
  double finite(std::size_t column, std::string_view field) const {
    const double x = number(column, field);
    if (std::isinf(x)) fail(column, quoted(field) + " is not finite");
    return x;
  }
  double coordinate(std::size_t column, std::string_view field) const {
    const double x = finite(column, field);
    check_coordinate(x, place(), std::string(kColumns[column]));
    return x;
  }
  bool flag(std::size_t column, std::string_view field) const {
    if (field != "0" && field != "1") fail(column, quoted(field) + " is neither 0 nor 1");
    return field == "1";
  }
  std::uint32_t primitive(std::string_view field) const {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
    if (error != std::errc() || end != field.data() + field.size() || number >= primitives_)
      fail(kIgnore, quoted(field) + " is no primitive's number; the scene has " + std::to_string(primitives_));
    return number;
  }

  const std::string& name_;
  std::string_view rest_;
  std::size_t primitives_;
  std::size_t line_ = 0;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> columns_;  // of the first line, by number
};

void append(std::string& text, const auto& number) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr);
}

}  // namespace

RayText parse_rays(const std::string& name, std::string_view text, std::size_t primitives) { return Parser(name, text, primitives).rays(); }

std::string text_of(const std::vector<Answer>& answers) {
  std::string text = "hit,prim,distance,t,u,v\n";
  for (const Answer& answer : answers) {
    text += answer.hit ? '1' : '0';
    const auto field = [&](const auto& value) {
      text += ',';
      if (value) append(text, *value);
    };
    field(answer.prim);
    field(answer.distance);
    field(answer.t);
    field(answer.u);
    field(answer.v);
    text += '\n';
  }
  return text;
}

}  // namespace castray::cli
