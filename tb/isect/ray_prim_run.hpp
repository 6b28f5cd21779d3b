// SPDX-License-Identifier: Apache-2.0
// Sends tests through the primitive pipe and compares each with the model; cases made by hand.
#pragma once
#include "Vray_prim.h"
#include "dut.hpp"
#include "prim_cases.hpp"

namespace castray::tb {

inline constexpr int kLatency = 11;

// Sends the cases with the source's stalls and compares each result with the model.
struct Sent {
  int accepted = 0, missed = 0;
};
inline Sent run(const std::vector<PrimCase>& cases, Stalls stalls = {}, unsigned seed = 1) {
  Dut<Vray_prim> dut(seed);
  Gate source(stalls.source, stalls.burst, seed);
  std::deque<std::pair<long, const PrimCase*>> pending;
  Sent sent;
  std::size_t next = 0;
  int wrong = 0;
  for (long cycle = 0; next < cases.size() || !pending.empty(); ++cycle) {
    const bool offer = next < cases.size() && source.open();
    dut->in_valid_i = offer;
    if (offer) {
      set_port(dut->in_ctx_i, cases[next].ctx);
      set_port(dut->in_ray_i, cases[next].ray);
      set_port(dut->in_prim_i, cases[next].prim);
      pending.emplace_back(cycle, &cases[next++]);
    }
    dut.settle();
    const bool due = !pending.empty() && pending.front().first + kLatency == cycle;
    EXPECT_EQ(dut->out_valid_o + dut->retire_o, due) << "cycle " << cycle;
    if (due) {
      const PrimCase& c = *pending.front().second;
      pending.pop_front();
      cand_t want;
      const bool accepted = ray_prim(c.ray, c.prim, c.ctx, want);
      ++(accepted ? sent.accepted : sent.missed);
      EXPECT_EQ(get_port<cand_t>(dut->out_o).ctx, c.ctx);
      const bool same = accepted == bool(dut->out_valid_o) && (!accepted || want == get_port<cand_t>(dut->out_o));
      EXPECT_TRUE(same) << "ray  " << to_text(c.ray) << "\nprim " << to_text(c.prim) << "\nmodel " << accepted << " "
                        << to_text(want) << "\nRTL   " << bool(dut->out_valid_o) << " "
                        << to_text(get_port<cand_t>(dut->out_o));
      if (!same && ++wrong > 5) return sent;
    }
    dut.tick();
  }
  return sent;
}

inline test_ray_t straight_ray(bool neg = false, bool cull = false, axis_t axis = 2) {
  test_ray_t ray;
  ray.org.x = ray.org.y = ray.org.z = 1000;
  ray.norm2 = 1 << NormFrac;
  ray.axis = axis, ray.neg = neg, ray.cull = cull;
  return ray;
}
inline PrimCase triangle(const test_ray_t& ray, delta3_t a, delta3_t b, delta3_t c) {
  PrimCase t;
  t.ray = ray;
  t.prim.number = 7;
  t.prim.a = at_delta(ray, a), t.prim.b = at_delta(ray, b), t.prim.c = at_delta(ray, c);
  return t;
}
inline PrimCase sphere(const test_ray_t& ray, delta3_t centre, std::int64_t radius) {
  PrimCase s;
  s.ray = ray;
  s.prim.number = 8, s.prim.kind = KindSphere;
  s.prim.a = at_delta(ray, centre);
  s.prim.b.x = static_cast<std::uint64_t>(radius);
  return s;
}
inline bool hits(const PrimCase& c) {
  cand_t cand;
  return ray_prim(c.ray, c.prim, c.ctx, cand);
}
inline cand_t cand_of(const PrimCase& c) {
  cand_t cand;
  EXPECT_TRUE(ray_prim(c.ray, c.prim, c.ctx, cand));
  return cand;
}

}  // namespace castray::tb
