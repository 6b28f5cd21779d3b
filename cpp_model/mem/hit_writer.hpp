// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/mem/hit_writer.sv: a hit as its record of the hit buffer, with what was done for it where that is
// asked for, and where it lies.
#pragma once
#include "fixed.hpp"

namespace castray {

inline hit_record_t hit_record(const hit_t& hit, const work_t& work = {}) {
  hit_record_t record;
  const bool whole = hit.found && !hit.any_hit;   // where it was hit is told
  record.t = whole ? hit.t : hit.found ? 0 : TMax;
  record.u = whole ? hit.u : 0;
  record.v = whole ? hit.v : 0;
  record.prim = whole ? hit.number : hit.found ? AnyHit : NoHit;
  record.instance_id = hit.found ? 0 : NoHit;
  record.nodes = work.nodes;
  record.tests = work.tests;
  return record;
}

inline bool is_hit(const hit_record_t& record) { return record.prim != NoHit; }

// Byte offset of a pixel's record in the hit buffer.
inline std::uint64_t hit_offset(const pixel_tag_t& tag, std::uint64_t width) {
  return (tag.y * width + tag.x) * HitBytes;
}

}  // namespace castray
