// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/ray_prim.sv: one ray against one primitive, exactly.
#pragma once
#include "isect/accept.hpp"
#include "isect/sphere_disc.hpp"

namespace castray {

// True, with `out` filled, if the ray's line meets the primitive; whether in front of the origin
// is for hit_unit to say. An empty slot, a sphere of radius 0 or of 2^(CoordW-1) and more: never.
inline bool ray_prim(const test_ray_t& ray, const prim_slot_t& prim, ctx_t ctx, cand_t& out) {
  if (prim.number == NoPrim) return false;
  if (prim.kind == KindTriangle) {
    const delta3_t a = corner_delta(prim.a, ray.org, ray.axis);
    const delta3_t b = corner_delta(prim.b, ray.org, ray.axis);
    const delta3_t c = corner_delta(prim.c, ray.org, ray.axis);
    sheared2_t sa, sb, sc;
    sa.x = shear(a.x, a.z, ray.sx), sb.x = shear(b.x, b.z, ray.sx), sc.x = shear(c.x, c.z, ray.sx);
    if (all_on_one_side(sa.x, sb.x, sc.x)) return false;
    sa.y = shear(a.y, a.z, ray.sy), sb.y = shear(b.y, b.z, ray.sy), sc.y = shear(c.y, c.z, ray.sy);
    if (all_on_one_side(sa.y, sb.y, sc.y)) return false;
    const edge_fns_t e = edge_fns(sa, sb, sc);
    if (!accept(e, ray.neg, ray.cull)) return false;
    const auto magnitude = [](edge_t x) { return static_cast<det_t>(x < 0 ? -x : x); };
    out.u = magnitude(e.u);
    out.v = magnitude(e.v);
    out.det = magnitude(e.u + e.v + e.w);
    out.az = -a.z;
    out.bz = -b.z;
    out.cz = -c.z;
  } else {
    const std::int64_t radius = static_cast<std::int64_t>(prim.b.x);
    if (!radius_legal(prim.b.x)) return false;
    const delta3_t c = corner_delta(prim.a, ray.org, ray.axis);
    const sphere_disc_t s = sphere_disc(shear(c, ray), radius, ray);
    if (!s.meets) return false;
    out.u = out.v = 0;
    out.det = static_cast<det_t>(s.disc);
    out.az = s.towards;
    out.bz = 0;
    out.cz = -c.z;
  }
  out.ctx = ctx;
  out.number = prim.number;
  out.kind = prim.kind;
  return true;
}

}  // namespace castray
