// SPDX-License-Identifier: Apache-2.0
// Mirrors the tags of rtl/mem/attr_cache.sv: which accesses hit. What the cache delivers is what
// lies in memory, so this is of use to counters and to studies of its size only.
#pragma once
#include <vector>

#include "fixed.hpp"

namespace castray {

// Two ways, least recently used.
class AttrCache {
 public:
  explicit AttrCache(int entries = 128) : sets_(entries / 2) {}

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
