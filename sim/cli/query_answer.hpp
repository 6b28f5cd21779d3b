// SPDX-License-Identifier: Apache-2.0
// What a ray of a list met, for people and programs: of a hit record, or of a reference.
#pragma once
#include <optional>

#include "reference/ray_list.hpp"
#include "scene/compile.hpp"

namespace castray::cli {

// What is not known stays empty: all of a miss; of any hit, which and where.
struct Answer {
  bool hit = false;
  std::optional<std::uint32_t> prim;
  std::optional<double> distance;  // from the origin, scene units
  std::optional<double> t;         // grid steps along the ray's dominant axis, as in the hit record
  std::optional<double> u, v;      // weights of corners 0 and 1
};

Answer answer_of(const SceneImage& image, const ListRay& ray, const hit_record_t& record);
Answer answer_of(const ListRay& ray, const ReferenceHit& hit);

}  // namespace castray::cli
