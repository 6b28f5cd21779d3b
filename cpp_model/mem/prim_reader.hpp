// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/mem/prim_reader.sv: the primitive buffer in reading order, without empty slots.
#pragma once
#include <vector>

#include "mem/image.hpp"

namespace castray {

inline std::vector<prim_slot_t> read_slots(const std::uint8_t* image, const image_header_t& header) {
  std::vector<prim_slot_t> slots;
  for (std::uint64_t i = 0; i < slot_count(header); ++i) {
    const prim_slot_t slot = load_slot(image, header, i);
    if (slot.number != static_cast<std::uint64_t>(NoPrim)) slots.push_back(slot);
  }
  return slots;
}

}  // namespace castray
