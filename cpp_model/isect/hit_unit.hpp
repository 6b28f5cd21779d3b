// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/hit_unit.sv: the distance of an accepted primitive, and where on it.
#pragma once
#include "isect/hit_distance.hpp"
#include "isect/hit_sphere.hpp"
#include "math/div_pipe.hpp"

namespace castray {

// True, with `out` filled, if the hit lies beyond tmin.
// A sphere takes its nearer root beyond tmin, else (unless back faces are culled) the farther.
inline bool hit_unit(const cand_t& cand, const hit_ray_t& ray, result_t& out) {
  const bool sphere = cand.kind == KindSphere;
  const quotient_job_t job = sphere ? hit_sphere(cand, ray) : hit_norm(cand);
  const std::uint64_t q0 = div_nearest(job.num0, job.den, BaryFrac);
  const std::uint64_t q1 = div_nearest(job.num1, job.den, BaryFrac);
  const along_t part0 = static_cast<along_t>(q0) * job.scale0;
  const along_t part1 = static_cast<along_t>(q1) * job.scale1;

  out.ctx = cand.ctx;
  out.number = cand.number;
  out.kind = cand.kind;
  if (!sphere) {
    out.u = q0;
    out.v = q1;
    out.t = triangle_distance(-cand.cz, part0, part1, ray.neg);
    return out.t > ray.tmin;
  }
  out.u = out.v = 0;
  out.t = sphere_distance(-cand.cz, part0, ray.neg);
  if (out.t > ray.tmin) return true;
  out.t = sphere_distance(-cand.cz, part1, ray.neg);
  return !ray.cull && out.t > ray.tmin;
}

}  // namespace castray
