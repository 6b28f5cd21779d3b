// SPDX-License-Identifier: Apache-2.0
#include "query_answer.hpp"

#include <cmath>

#include "scene/ray_record.hpp"

namespace castray::cli {
namespace {

double fixed(std::uint64_t value, std::int64_t fraction_bits) { return std::ldexp(static_cast<double>(value), -static_cast<int>(fraction_bits)); }

}  // namespace

Answer answer_of(const SceneImage& image, const ListRay& ray, const hit_record_t& record) {
  if (record.prim == std::uint64_t{NoHit}) return {};
  if (record.prim == std::uint64_t{AnyHit}) return {.hit = true};
  return {.hit = true,
          .prim = static_cast<std::uint32_t>(record.prim),
          .distance = ray_distance(image, ray, record.t),
          .t = std::ldexp(static_cast<double>(record.t), -static_cast<int>(TFrac)),
          .u = fixed(record.u, BaryFrac),
          .v = fixed(record.v, BaryFrac)};
}

Answer answer_of(const ListRay& ray, const ReferenceHit& hit) {
  if (hit.prim < 0 || ray.any) return {.hit = hit.prim >= 0};
  return {.hit = true, .prim = static_cast<std::uint32_t>(hit.prim), .distance = hit.distance, .t = {}, .u = hit.u, .v = hit.v};
}

}  // namespace castray::cli
