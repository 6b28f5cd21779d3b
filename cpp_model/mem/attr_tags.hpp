// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/mem/attr_tags.sv: which accesses of the attribute cache hit. What the cache delivers is
// what lies in memory, so no pixel depends on it.
#pragma once
#include <vector>

#include "fixed.hpp"

namespace castray {

// Two ways, least recently used.
class AttrTags {
 public:
  explicit AttrTags(int entries = DefaultAttrEntries) : sets_(entries / 2) {}

  // Looks a primitive up, and keeps it from now on. True: it was there.
  bool access(prim_t number) {
    Set& set = sets_[number % sets_.size()];
    int way = 0;
    while (way < 2 && set.number[way] != number) ++way;
    const bool hit = way < 2;
    if (!hit) way = set.number[0] == NoPrim ? 0 : set.number[1] == NoPrim ? 1 : 1 - set.last;
    set.number[way] = number;
    set.last = way;
    return hit;
  }

 private:
  struct Set {
    prim_t number[2] = {NoPrim, NoPrim};
    int last = 0;
  };
  std::vector<Set> sets_;
};

}  // namespace castray
