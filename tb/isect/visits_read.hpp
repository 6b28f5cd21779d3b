// SPDX-License-Identifier: Apache-2.0
// What is read of a node's visits: of an entry without a target only that it has none.
#pragma once
#include "castray_records.hpp"

namespace castray::tb {

inline visits_t as_read(visits_t visits) {
  for (entry_t* entry : {&visits.e0, &visits.e1, &visits.e2, &visits.e3})
    if (entry->target.kind == static_cast<std::uint64_t>(RefNone)) *entry = {};
  return visits;
}

}  // namespace castray::tb
