// SPDX-License-Identifier: Apache-2.0
// What passes inside the core, for `castray ray`: stream_probe.sv, bound to the streams of the
// Verilated core, calls castray_probe for each item while a Probe is attached.
#pragma once
#include <cstdint>
#include <vector>

#include "fixed.hpp"

namespace castray::sim {

struct Probe {
  std::vector<pixel_dir_t> directions;
  std::vector<ray_t> rays;
  std::vector<cand_t> candidates;
  std::vector<result_t> results;
  std::vector<hit_t> hits;
  std::vector<shaded_t> shaded;

  // Attached for as long as this object lives; one at a time.
  class Attached {
   public:
    explicit Attached(Probe& probe);
    ~Attached();
    Attached(const Attached&) = delete;
    Attached& operator=(const Attached&) = delete;
  };

  // Nothing is noted for as long as this object lives: registers without reset hold anything while
  // the core is reset, and what seems to pass then is no item.
  class Muted {
   public:
    Muted();
    ~Muted();
    Muted(const Muted&) = delete;
    Muted& operator=(const Muted&) = delete;
  };
};

}  // namespace castray::sim
