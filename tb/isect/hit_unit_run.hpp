// SPDX-License-Identifier: Apache-2.0
// Sends candidates through the hit unit and compares each with the model; cases made by hand.
#pragma once
#include "Vhit_unit.h"
#include "dut.hpp"
#include "isect/hit_unit.hpp"
#include "prim_cases.hpp"

namespace castray::tb {

inline constexpr std::int64_t kStep = 1 << TFrac;           // of a distance
inline constexpr std::int64_t kQuarter = 1 << (TFrac - 2);  // a quarter step
inline constexpr int kGain = HitDivW - 2 - BaryFrac;        // bits of a numerator beyond its quotient's

struct HitCase {
  cand_t cand;
  hit_ray_t ray;
};

struct Outcome {
  std::vector<result_t> out;
  long cycles = 0;
};

// Sends the cases and checks that as many retire, that only those beyond tmin come out, as the model
// says: the triangles in order, and so the spheres. Lanes are their cases' in turn.
inline Outcome run(const std::vector<HitCase>& cases, Stalls stalls = {}, unsigned seed = 1) {
  Dut<Vhit_unit> dut(seed);
  Gate source(stalls.source, stalls.burst, seed);
  std::deque<const HitCase*> pending[2];  // of each kind
  Outcome result;
  std::size_t next = 0, retired = 0;
  bool offering = false;
  int wrong = 0;
  const long limit = 1000 + 80L * static_cast<long>(cases.size());
  for (; retired < cases.size() && result.cycles < limit; ++result.cycles) {
    if (!offering && next < cases.size()) offering = source.open();
    dut->in_valid_i = offering;
    if (offering) {
      set_port(dut->in_i, cases[next].cand);
      set_port(dut->in_ray_i, cases[next].ray);
      dut->in_lane_i = next % MaxLanes;
    }
    dut.settle();
    if (offering && dut->in_ready_o) {
      pending[cases[next].cand.kind].push_back(&cases[next]);
      ++next;
      offering = false;
    }
    if (dut->out_valid_o) EXPECT_TRUE(dut->retire_o) << "a result without its candidate";
    if (dut->retire_o) {
      const result_t got = get_port<result_t>(dut->out_o);
      if (pending[got.kind].empty()) {
        ADD_FAILURE() << "retired twice";
        break;
      }
      const HitCase& c = *pending[got.kind].front();
      pending[got.kind].pop_front();
      ++retired;
      result_t want;
      const bool emitted = hit_unit(c.cand, c.ray, want);
      EXPECT_EQ(dut->out_lane_o, static_cast<std::size_t>(&c - cases.data()) % MaxLanes);
      EXPECT_EQ(got.ctx, c.cand.ctx);
      const bool same = emitted == bool(dut->out_valid_o) && (!emitted || want == got);
      if (emitted) result.out.push_back(got);
      EXPECT_TRUE(same) << "cand  " << to_text(c.cand) << "\nray   " << to_text(c.ray) << "\nmodel " << emitted << " "
                        << to_text(want) << "\nRTL   " << bool(dut->out_valid_o) << " " << to_text(got);
      if (!same && ++wrong > 5) return result;
    }
    dut.tick();
  }
  EXPECT_EQ(retired, cases.size());
  return result;
}

inline hit_ray_t straight(bool neg = false, t_t tmin = 0) {
  hit_ray_t ray;
  ray.norm2 = 1 << NormFrac;
  ray.neg = neg, ray.tmin = tmin;
  return ray;
}
inline HitCase triangle(std::uint64_t u, std::uint64_t v, std::uint64_t det, std::int64_t az, std::int64_t bz, std::int64_t cz,
                 hit_ray_t ray = straight(false, -TMax)) {
  HitCase c;
  c.cand.u = u, c.cand.v = v, c.cand.det = det;
  c.cand.az = -az, c.cand.bz = -bz, c.cand.cz = -cz;   // turned back
  c.cand.number = 5, c.cand.ctx = 3;
  c.ray = ray;
  return c;
}
// A sphere at cz whose discriminant is disc; towards in quarter steps.
inline HitCase sphere(std::int64_t cz, std::uint64_t disc, std::int64_t towards, hit_ray_t ray) {
  HitCase c;
  c.cand.kind = KindSphere;
  c.cand.det = disc, c.cand.az = towards, c.cand.cz = -cz;
  c.cand.number = 6, c.cand.ctx = 4;
  c.ray = ray;
  return c;
}
inline result_t one(const HitCase& c) {
  const Outcome r = run({c});
  EXPECT_EQ(r.out.size(), 1u);
  return r.out.empty() ? result_t{} : r.out[0];
}
inline bool emitted(const HitCase& c) { return run({c}).out.size() == 1; }

// What the primitive pipe accepts of random tests, with a random tmin.
inline std::vector<HitCase> accepted_cases(int n, unsigned seed) {
  Rng rng(seed);
  std::vector<HitCase> cases;
  while (static_cast<int>(cases.size()) < n) {
    const PrimCase p = random_case(rng);
    HitCase c;
    if (!ray_prim(p.ray, p.prim, p.ctx, c.cand)) continue;
    c.ray.norm2 = p.ray.norm2, c.ray.neg = p.ray.neg, c.ray.cull = p.ray.cull;
    c.ray.tmin = rng.chance(3) ? rng.in(-TMax, TMax) : 0;
    cases.push_back(c);
  }
  return cases;
}
// Any magnitudes that a candidate may have, more extreme than geometry makes them.
inline HitCase any_triangle(Rng& rng) {
  const std::uint64_t det = static_cast<std::uint64_t>(rng.in(1, std::int64_t{1} << rng.in(0, 2 * CoordW + 2)));
  const std::uint64_t u = rng.chance(6) ? (rng.chance(2) ? 0 : det) : static_cast<std::uint64_t>(rng.in(0, static_cast<std::int64_t>(det)));
  const std::uint64_t v = rng.chance(3) ? det - u : static_cast<std::uint64_t>(rng.in(0, static_cast<std::int64_t>(det - u)));
  const std::int64_t org = static_cast<std::int64_t>(rng.coord());
  const auto z = [&] { return static_cast<std::int64_t>(rng.coord()) - org; };
  return triangle(u, v, det, z(), z(), z(), straight(rng.chance(2), rng.chance(3) ? rng.in(-TMax, TMax) : 0));
}

}  // namespace castray::tb
