// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/hit_norm.sv: from a candidate to two divisions, u and v of a triangle.
#pragma once
#include "fixed.hpp"

namespace castray {

// Two divisions; the quotient times `scale` is what each adds to the distance.
struct quotient_job_t {
  std::uint64_t num0 = 0, num1 = 0, den = 0;  // HitDivW bits, num <= den, den has its top bit set
  std::int64_t scale0 = 0, scale1 = 0;        // steps (triangle), or +-2^k quarter steps (sphere)
};

// x shifted so that bit `top` comes to HitDivW - 1: exact to the left, truncated to the right.
constexpr std::uint64_t norm_shift(det_t x, int top) {
  return static_cast<std::uint64_t>(top >= HitDivW - 1 ? x >> (top - (HitDivW - 1)) : x << (HitDivW - 1 - top));
}

inline quotient_job_t hit_norm(const cand_t& cand) {
  const int top = msb(det_t{cand.det | 1});
  quotient_job_t job;
  job.num0 = norm_shift(cand.u, top);
  job.num1 = norm_shift(cand.v, top);
  job.den = norm_shift(cand.det, top);
  job.scale0 = wrap_signed(cand.cz - cand.az, CoordW + 1);
  job.scale1 = wrap_signed(cand.cz - cand.bz, CoordW + 1);
  return job;
}

}  // namespace castray
