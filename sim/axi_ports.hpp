// SPDX-License-Identifier: Apache-2.0
// The signals of an AXI4 port of 128-bit data in one cycle, as plain values.
#pragma once
#include <array>
#include <cstdint>

namespace castray::sim {

inline constexpr unsigned kBeatBytes = 16;

enum AxiResponse : std::uint8_t { kOkay = 0, kExOkay = 1, kSlvErr = 2, kDecErr = 3 };

// The payload of AR or AW.
struct AxiAddress {
  std::uint64_t address = 0;
  std::uint8_t id = 0;
  std::uint8_t length = 0;     // beats - 1
  std::uint8_t size = 4;       // log2 of a beat's bytes
  std::uint8_t burst = 1;      // INCR
  std::uint8_t cache = 0b0011; // normal, bufferable, not cacheable
  bool operator==(const AxiAddress&) const = default;

  unsigned beats() const { return length + 1u; }
  std::uint64_t bytes() const { return std::uint64_t{beats()} << size; }
};

// The payload of W.
struct AxiData {
  std::array<std::uint32_t, 4> data{};
  std::uint16_t strobes = 0;
  bool last = false;
  bool operator==(const AxiData&) const = default;
};

// What the manager drives. A payload counts only while its valid is high.
struct AxiManager {
  bool ar_valid = false;
  bool aw_valid = false;
  bool w_valid = false;
  bool r_ready = false;
  bool b_ready = false;
  AxiAddress ar;
  AxiAddress aw;
  AxiData w;
};

// What the subordinate drives.
struct AxiSubordinate {
  bool ar_ready = false;
  bool aw_ready = false;
  bool w_ready = false;
  bool r_valid = false;
  bool b_valid = false;
  bool r_last = false;
  std::uint8_t r_id = 0;
  std::uint8_t r_response = kOkay;
  std::uint8_t b_id = 0;
  std::uint8_t b_response = kOkay;
  std::array<std::uint32_t, 4> r_data{};
};

}  // namespace castray::sim
