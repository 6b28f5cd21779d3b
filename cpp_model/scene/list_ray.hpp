// SPDX-License-Identifier: Apache-2.0
// A ray of a list in world coordinates, as the references and the maker of ray records take it.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>

#include "scene/scene.hpp"

namespace castray {

struct ListRay {
  Vec3 origin = Vec3(0);
  Vec3 direction = Vec3(0);  // of any length but zero
  double tmin = 0;           // hits lie between tmin and tmax, distances in scene units
  double tmax = std::numeric_limits<double>::infinity();
  bool any = false;          // any hit will do: yes or no
  bool cull = false;         // back faces are not hit
  std::optional<std::uint32_t> ignore;  // this primitive is not hit
};

}  // namespace castray
