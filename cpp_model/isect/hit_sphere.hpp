// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/hit_sphere.sv: the two divisions of a sphere, (b - root) / norm2 and (b + root) / norm2, in quarter steps.
#pragma once
#include <algorithm>

#include "isect/hit_norm.hpp"
#include "math/root_pipe.hpp"

namespace castray {

// |x| with at most HitDivW - 1 bits, and the power of two by which that is too small.
struct small_t {
  std::uint64_t value = 0;
  int shift = 0;
};
inline small_t small_of(std::int64_t x) {
  const std::uint64_t m = static_cast<std::uint64_t>(x < 0 ? -x : x);
  const int shift = std::max(0, msb(m) - int{HitDivW - 2});
  return {m >> shift, shift};
}

inline quotient_job_t hit_sphere(const cand_t& cand, const hit_ray_t& ray) {
  const std::int64_t root = static_cast<std::int64_t>(isqrt(static_cast<int_of<det_t_bits + 6>>(cand.det) << 5));
  const std::int64_t b = ray.neg ? -cand.az : cand.az;
  const int half = ray.norm2 >> (NormFrac + 1) ? 0 : 1;  // norm2 below two
  const int gain = HitDivW - 2 - BaryFrac;                // of the quotient of aligned operands
  const auto scale = [&](std::int64_t x, int shift) {
    const std::int64_t power = std::int64_t{1} << (shift + half + gain);
    return x < 0 ? -power : power;
  };
  const small_t near = small_of(b - root), far = small_of(b + root);
  quotient_job_t job;
  job.num0 = near.value;
  job.num1 = far.value;
  job.den = static_cast<std::uint64_t>(static_cast<uint128>(ray.norm2) << half << HitDivW >> (NormFrac + 2));
  job.scale0 = scale(b - root, near.shift);
  job.scale1 = scale(b + root, far.shift);
  return job;
}

}  // namespace castray
