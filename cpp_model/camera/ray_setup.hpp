// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/camera/ray_setup.sv: the ray of a request, its shear divided once and for all.
#pragma once
#include "isect/corner_delta.hpp"
#include "math/div_pipe.hpp"

namespace castray {

// num / den below one, ShearFrac bits, operands cut to ShearDivW bits. Needs |num| <= |den|, den != 0.
inline std::int64_t shear_quotient(std::int64_t num, std::int64_t den) {
  const auto magnitude = [](std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); };
  const int shift = msb(magnitude(den)) - static_cast<int>(ShearDivW - 1);
  const auto cut = [&](std::uint64_t v) { return shift >= 0 ? v >> shift : v << -shift; };
  const auto limit = (std::uint64_t{1} << ShearFrac) - 1;
  const std::uint64_t q = div_nearest(cut(magnitude(num)), cut(magnitude(den)), static_cast<int>(ShearFrac));
  const auto s = static_cast<std::int64_t>(q < limit ? q : limit);
  return (num < 0) != (den < 0) ? -s : s;
}

// What a camera asks for.
inline ray_req_t camera_request(const dir_t& dir, const camera_t& camera, const pixel_tag_t& tag) {
  ray_req_t req;
  req.tag = tag;
  req.org = camera.eye;
  req.dir = dir;
  req.tmax = TMax;
  req.ok = 1;
  req.ignore = NoPrim;
  return req;
}

inline ray_t ray_setup(const ray_req_t& req) {
  const dir_t& dir = req.dir;
  const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
  const std::int64_t mx = magnitude(dir.x), my = magnitude(dir.y), mz = magnitude(dir.z);
  const bool valid = (mx | my | mz) != 0;

  ray_t ray;
  ray.axis = mx >= my && mx >= mz ? 0 : my >= mz ? 1 : 2;  // equal: the lowest; zero: 0
  const auto [n0, n1, dom] = permute({dir.x, dir.y, dir.z}, ray.axis);
  ray.tag = req.tag;
  ray.org = permuted(req.org, ray.axis);
  ray.sx = valid ? shear_quotient(n0, dom) : 0;
  ray.sy = valid ? shear_quotient(n1, dom) : 0;
  using square_t = int_of<2 * ShearFrac + 3>;
  const square_t sx = ray.sx, sy = ray.sy, one = square_t{1} << (2 * ShearFrac);
  ray.norm2 = static_cast<norm2_t>(round_shift(one + sx * sx + sy * sy, 2 * ShearFrac - NormFrac));
  ray.neg = dom < 0;
  ray.valid = valid && req.ok;
  ray.cull = req.cull;
  ray.any_hit = req.any_hit;
  ray.tmin = req.tmin;
  ray.tmax = req.tmax;
  ray.ignore = req.ignore;
  return ray;
}

inline ray_t ray_setup(const dir_t& dir, const camera_t& camera, const pixel_tag_t& tag) {
  return ray_setup(camera_request(dir, camera, tag));
}

}  // namespace castray
