// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/leaf_tests.sv: the tests of a leaf.
#pragma once
#include "mem/image.hpp"

namespace castray {

// test(slot) for each primitive of the leaf that the ray does not ignore. ErrLeaf, ErrPrimitive: none.
template <class Test>
error_t leaf_tests(const std::uint8_t* image, const image_header_t& header, line_t index, prim_t ignore, Test&& test) {
  if (index >= header.lines.count) return ErrLeaf;
  const prim_slot_t slots[] = {load_slot(image, header, 2 * index), load_slot(image, header, 2 * index + 1)};
  for (const prim_slot_t& slot : slots)
    if (!slot_ok(slot, header)) return ErrPrimitive;
  for (const prim_slot_t& slot : slots)
    if (slot.number != static_cast<std::uint64_t>(NoPrim) && slot.number != ignore) test(slot);
  return ErrNone;
}

}  // namespace castray
