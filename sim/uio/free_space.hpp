// SPDX-License-Identifier: Apache-2.0
// Which parts of a piece of memory are taken: first fit, in whole pages.
#pragma once
#include <cstdint>
#include <map>
#include <optional>

namespace castray::sim {

class FreeSpace {
 public:
  static constexpr std::uint64_t kPage = 4096;

  explicit FreeSpace(std::uint64_t bytes) : bytes_(bytes) {}

  // The offset of a part that was free, of a page at least; none if no such part is left.
  std::optional<std::uint64_t> take(std::uint64_t bytes) {
    const std::uint64_t wanted = bytes == 0 ? kPage : (bytes + kPage - 1) / kPage * kPage;
    std::uint64_t at = 0;
    for (const auto& [first, taken] : taken_) {
      if (first - at >= wanted) break;
      at = first + taken;
    }
    if (wanted < bytes || at > bytes_ || wanted > bytes_ - at) return std::nullopt;
    taken_.emplace(at, wanted);
    return at;
  }
  void give(std::uint64_t offset) { taken_.erase(offset); }

  // Whether one taken part holds all of [offset, offset + bytes).
  bool holds(std::uint64_t offset, std::uint64_t bytes) const {
    auto part = taken_.upper_bound(offset);
    if (part == taken_.begin()) return false;
    --part;
    const std::uint64_t into = offset - part->first;
    return into <= part->second && bytes <= part->second - into;
  }
  std::uint64_t left() const {
    std::uint64_t left = bytes_;
    for (const auto& [first, taken] : taken_) left -= taken;
    return left;
  }

 private:
  std::uint64_t bytes_;
  std::map<std::uint64_t, std::uint64_t> taken_;  // bytes of each part by its offset
};

}  // namespace castray::sim
