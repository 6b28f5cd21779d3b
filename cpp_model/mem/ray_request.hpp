// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/mem/ray_request.sv: what a record of a list asks for.
#pragma once
#include <algorithm>

#include "mem/image.hpp"

namespace castray {

// No flag is set that is none: else ErrRay.
inline bool ray_flags_ok(const ray_record_t& record) { return record.flags >> NumRayFlags == 0; }

// The ray of number `number`. It hits nothing if its origin lies outside the scene's grid, its direction
// exceeds the format or the range is empty; a negative tmin counts as 0, a tmax above TMax as TMax.
inline ray_req_t ray_request(const ray_record_t& record, std::uint64_t number) {
  const auto fits = [](std::int64_t component) { return component == wrap_signed(component, dir_comp_t_bits); };
  const auto clamp = [](std::int64_t t) { return std::clamp<std::int64_t>(t, 0, TMax); };
  const auto coord = [](std::uint64_t c) { return low_bits(c, coord_t_bits); };
  ray_req_t req;
  req.tag.x = low_bits(number, pixel_t_bits);
  req.tag.y = low_bits(number >> pixel_t_bits, pixel_t_bits);
  req.org.x = coord(record.org_x), req.org.y = coord(record.org_y), req.org.z = coord(record.org_z);
  req.dir.x = wrap_signed(record.dir_x, dir_comp_t_bits);
  req.dir.y = wrap_signed(record.dir_y, dir_comp_t_bits);
  req.dir.z = wrap_signed(record.dir_z, dir_comp_t_bits);
  req.tmin = clamp(record.tmin);
  req.tmax = clamp(record.tmax);
  req.cull = record.flags >> RayCull & 1;
  req.any_hit = record.flags >> RayAnyHit & 1;
  req.ignore = std::min<std::uint64_t>(record.ignore, NoPrim);
  req.ok = ((record.org_x | record.org_y | record.org_z) >> CoordW) == 0 && req.tmin < req.tmax && fits(record.dir_x) &&
           fits(record.dir_y) && fits(record.dir_z);
  return req;
}

// The record of a ray without bounds or flags.
inline ray_record_t ray_record(const point_t& org, const dir_t& dir) {
  ray_record_t record;
  record.org_x = org.x, record.org_y = org.y, record.org_z = org.z;
  record.dir_x = dir.x, record.dir_y = dir.y, record.dir_z = dir.z;
  record.tmax = TMax;
  record.ignore = NoHit;
  return record;
}

inline ray_record_t load_ray(const std::uint8_t* list, std::uint64_t number) {
  return load_record<ray_record_t>(list + number * RayBytes);
}

}  // namespace castray
