// SPDX-License-Identifier: Apache-2.0
// The stages of one ray as a table on stdout: the model's values beside the RTL's.
#pragma once
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "ray_fields.hpp"

namespace castray::cli {

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
      const auto left = i < model.size() ? fields(model[i]) : Fields{};
      const auto right = i < rtl.size() ? fields(rtl[i]) : Fields{};
      for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k) {
        const std::string& key = k < left.size() ? left[k].name : right[k].name;
        const std::string a = k < left.size() ? left[k].value : "-", b = k < right.size() ? right[k].value : "-";
        differ_ += a != b;
        if (shown || a != b) std::printf("  %-18s %26s %26s%s\n", key.c_str(), a.c_str(), b.c_str(), a == b ? "" : "   <-- differs");
      }
      if (shown && i + 1 < count && std::max(left.size(), right.size()) > 1) std::printf("\n");
    }
    if (count > static_cast<std::size_t>(limit_)) std::printf("  ... %zu in all\n", count);
  }
  std::size_t differ() const { return differ_; }

 private:
  int limit_;
  std::size_t differ_ = 0;
};

}  // namespace castray::cli
