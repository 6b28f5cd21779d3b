// SPDX-License-Identifier: Apache-2.0
// The stages of one ray as a table on stdout: the model's values beside the RTL's.
#pragma once
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "fixed.hpp"

namespace castray::cli {

// A record's fields one by one; those of a stream that numbers places, not values, are left out.
struct Field {
  std::string name;
  std::string value;
};
template <class Record> std::vector<Field> fields(const Record& record) {
  std::vector<Field> list;
  record.each_field([&](std::string_view name, const auto& value, int, int, bool is_signed) {
    if (name == "tag.slot" || name == "ctx" || name == "hit.tag.slot") return;
    if constexpr (requires { static_cast<std::uint64_t>(value); })
      list.push_back({std::string(name), is_signed ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(static_cast<std::uint64_t>(value))});
  });
  return list;
}

class RaySheet {
 public:
  explicit RaySheet(int limit) : limit_(limit) {}

  // The items of one stage in both; what lies beyond the limit is shown where it differs.
  template <class Record> void stage(const char* name, const std::vector<Record>& model, const std::vector<Record>& rtl) {
    const std::size_t count = std::max(model.size(), rtl.size());
    if (count == 0) return;
    std::printf("%s%s\n", name, model.size() == rtl.size() ? "" : "   (not as many in the model as in the RTL)");
    for (std::size_t i = 0; i < count; ++i) {
      const bool shown = i < static_cast<std::size_t>(limit_);
      const auto left = i < model.size() ? fields(model[i]) : std::vector<Field>{};
      const auto right = i < rtl.size() ? fields(rtl[i]) : std::vector<Field>{};
      for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k) {
        const std::string& key = k < left.size() ? left[k].name : right[k].name;
        const std::string a = k < left.size() ? left[k].value : "-", b = k < right.size() ? right[k].value : "-";
        differ_ += a != b;
        if (shown || a != b) std::printf("  %-18s %24s %24s%s\n", key.c_str(), a.c_str(), b.c_str(), a == b ? "" : "   <-- differs");
      }
      if (shown && i + 1 < count) std::printf("\n");
    }
    if (count > static_cast<std::size_t>(limit_)) std::printf("  ... %zu in all\n", count);
  }
  std::size_t differ() const { return differ_; }

 private:
  int limit_;
  std::size_t differ_ = 0;
};

}  // namespace castray::cli
