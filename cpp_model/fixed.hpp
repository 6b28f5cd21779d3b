// SPDX-License-Identifier: Apache-2.0
// Integer arithmetic of known width, and the packing of records into bits.
//
// The model is written in plain 64-bit integers whose formats are named in castray_records.hpp;
// fits_signed() states a width where one could be exceeded. Precision is lost in round_shift() and
// where docs/number-formats.md says truncated or floor. Wider products use int128.
#pragma once
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>

#include "castray_records.hpp"

namespace castray {

using int128 = __int128;
using uint128 = unsigned __int128;

// The integer for `bits` bits, the sign's among them: 64 of them where they are enough, as they are for the widths that
// the RTL may have. tools/width/ studies wider ones.
template <int Bits> using int_of = std::conditional_t<(Bits <= 64), std::int64_t, int128>;

// True if x fits a signed number of `bits` bits.
constexpr bool fits_signed(int128 x, int bits) {
  return x >= -(int128{1} << (bits - 1)) && x < (int128{1} << (bits - 1));
}

// x as the two's complement value of its lowest `bits` bits: what a register of that width holds.
constexpr std::int64_t wrap_signed(std::int64_t x, int bits) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << (64 - bits)) >> (64 - bits);
}

// The lowest `bits` bits of x, fewer than 64, as an unsigned number.
constexpr std::uint64_t low_bits(std::uint64_t x, std::int64_t bits) { return x & ((std::uint64_t{1} << bits) - 1); }

// x / 2^bits to the nearest integer, halves towards plus infinity: add half, floor.
constexpr std::int64_t round_shift(std::int64_t x, int bits) {
  return bits == 0 ? x : (x + (std::int64_t{1} << (bits - 1))) >> bits;
}
constexpr int128 round_shift(int128 x, int bits) {
  return bits == 0 ? x : (x + (int128{1} << (bits - 1))) >> bits;
}

// Position of the highest one of x, -1 for zero.
constexpr int msb(std::uint64_t x) { return 63 - std::countl_zero(x); }
constexpr int msb(uint128 x) { return x >> 64 ? 64 + msb(static_cast<std::uint64_t>(x >> 64)) : msb(static_cast<std::uint64_t>(x)); }

// ---- Records and bits ----

// Bits [at, at + bits) of a little-endian array of words.
inline std::uint64_t get_bits(const std::uint32_t* words, int at, int bits) {
  std::uint64_t value = 0;
  for (int done = 0; done < bits;) {
    const int in_word = (at + done) % 32;
    const int take = std::min(bits - done, 32 - in_word);
    const std::uint64_t part = (words[(at + done) / 32] >> in_word) & ((std::uint64_t{1} << take) - 1);
    value |= part << done;
    done += take;
  }
  return value;
}

inline void set_bits(std::uint32_t* words, int at, int bits, std::uint64_t value) {
  for (int done = 0; done < bits;) {
    const int in_word = (at + done) % 32;
    const int take = std::min(bits - done, 32 - in_word);
    const std::uint32_t mask = static_cast<std::uint32_t>(((std::uint64_t{1} << take) - 1) << in_word);
    std::uint32_t& word = words[(at + done) / 32];
    word = (word & ~mask) | (static_cast<std::uint32_t>((value >> done) << in_word) & mask);
    done += take;
  }
}

template <class Record> constexpr int words_of = (Record::kBits + 31) / 32;
template <class Record> using packed_t = std::array<std::uint32_t, words_of<Record>>;

// The bits of a record in the order of its SystemVerilog struct.
template <class Record> packed_t<Record> pack(const Record& record) {
  packed_t<Record> words{};
  record.each_field([&](const auto&, const auto& value, int at, int bits, bool) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_integral_v<Value> || std::is_enum_v<Value>) {
      set_bits(words.data(), at, bits, static_cast<std::uint64_t>(value));
    } else {
      for (int done = 0; done < bits; done += 32)
        set_bits(words.data(), at + done, std::min(32, bits - done), value[done / 32]);
    }
  });
  return words;
}

template <class Record> Record unpack(const std::uint32_t* words) {
  Record record;
  record.each_field([&](const auto&, auto& value, int at, int bits, bool is_signed) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_integral_v<Value> || std::is_enum_v<Value>) {
      const std::uint64_t raw = get_bits(words, at, bits);
      value = static_cast<Value>(is_signed ? static_cast<std::uint64_t>(wrap_signed(static_cast<std::int64_t>(raw), bits)) : raw);
    } else {
      for (int done = 0; done < bits; done += 32)
        value[done / 32] = static_cast<std::uint32_t>(get_bits(words, at + done, std::min(32, bits - done)));
    }
  });
  return record;
}

// A record as text, "name=value" for each field: for messages of tests and of `castray ray`.
template <class Record> std::string to_text(const Record& record) {
  std::string text;
  record.each_field([&](std::string_view name, const auto& value, int, int, bool is_signed) {
    using Value = std::decay_t<decltype(value)>;
    text += (text.empty() ? "" : " ") + std::string(name) + "=";
    if constexpr (std::is_integral_v<Value> || std::is_enum_v<Value>) {
      text += is_signed ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(static_cast<std::uint64_t>(value));
    } else {
      char word[12];
      for (auto it = value.rbegin(); it != value.rend(); ++it) {
        std::snprintf(word, sizeof word, "%08x", *it);
        text += word;
      }
    }
  });
  return text;
}

}  // namespace castray
