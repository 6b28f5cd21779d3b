// SPDX-License-Identifier: Apache-2.0
// Copies to and from memory that is mapped as a device's: there an access must be aligned to its size, which the
// library's own copies do not promise.
#pragma once
#include <cstdint>
#include <cstring>
#include <span>

namespace castray::sim {

inline bool on_word(const volatile std::uint8_t* at, std::size_t left) {
  return reinterpret_cast<std::uintptr_t>(at) % sizeof(std::uint64_t) == 0 && left >= sizeof(std::uint64_t);
}

inline void copy_out(volatile std::uint8_t* to, std::span<const std::uint8_t> from) {
  for (std::size_t i = 0; i < from.size();) {
    if (on_word(to + i, from.size() - i)) {
      std::uint64_t word;
      std::memcpy(&word, &from[i], sizeof word);
      *reinterpret_cast<volatile std::uint64_t*>(to + i) = word;
      i += sizeof word;
    } else {
      to[i] = from[i];
      ++i;
    }
  }
}

inline void copy_in(std::span<std::uint8_t> to, const volatile std::uint8_t* from) {
  for (std::size_t i = 0; i < to.size();) {
    if (on_word(from + i, to.size() - i)) {
      const std::uint64_t word = *reinterpret_cast<const volatile std::uint64_t*>(from + i);
      std::memcpy(&to[i], &word, sizeof word);
      i += sizeof word;
    } else {
      to[i] = from[i];
      ++i;
    }
  }
}

}  // namespace castray::sim
