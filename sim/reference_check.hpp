// SPDX-License-Identifier: Apache-2.0
// A rendering against the float64 reference: which pixels see another primitive, and how far the
// colours are apart where both see the same primitive and the same cell of its checker.
#pragma once
#include <cstddef>

#include "driver.hpp"
#include "reference/float64.hpp"
#include "scene/compile.hpp"

namespace castray::sim {

struct ReferenceCheck {
  std::size_t pixels = 0;
  std::size_t hits = 0;             // of the rendering
  std::size_t other_primitive = 0;  // a hit against a miss included
  std::size_t other_cell = 0;       // same primitive, another colour of the checker
  std::size_t far_colour = 0;       // neither, yet a channel is more than one of 255 away
  int worst = 0;                    // largest distance of a channel among those
};

// The rendering must have its hit records.
ReferenceCheck check_reference(const Scene& scene, const SceneImage& image, const Rendering& rendering, const ReferenceFrame& reference);

}  // namespace castray::sim
