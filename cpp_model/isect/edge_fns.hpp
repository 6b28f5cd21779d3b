// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/edge_fns.sv: the three edge functions of a sheared triangle and the side of each
// edge on which the ray lies.
#pragma once
#include "isect/shear.hpp"

namespace castray {

using edge_t = int_of<2 * CoordW + 4>;

struct edge_fns_t {
  edge_t u = 0, v = 0, w = 0;                // exact, units of four square steps
  bool u_neg = 0, v_neg = 0, w_neg = 0;  // their signs, those of zeros decided by the perturbation
  bool point = 0;                        // the three sheared corners coincide
};

// Moving the ray by (e, e^2) adds e (Cy - By) + e^2 (Bx - Cx) to U: where U is zero its sign is
// that of rank(C) - rank(B), with rank ordering corners by y, then by descending x.
inline edge_t rank(const sheared2_t& p) { return (edge_t{p.y} << (CoordW + 2)) - p.x; }

// True if the ray is surely outside: all three corners lie on one side of a line through it.
// Such a triangle is never accepted; most of a scene is dropped here.
inline bool all_on_one_side(sheared_t a, sheared_t b, sheared_t c) {
  return (a & b & c) < 0 || ((a - 1) | (b - 1) | (c - 1)) >= 0;
}

inline edge_fns_t edge_fns(const sheared2_t& a, const sheared2_t& b, const sheared2_t& c) {
  const edge_t ra = rank(a), rb = rank(b), rc = rank(c);
  const bool u_up = rc > rb, v_up = ra > rc, w_up = rb > ra;
  edge_fns_t e;
  const auto area = [](const sheared2_t& p, const sheared2_t& q) { return edge_t{p.x} * q.y - edge_t{p.y} * q.x; };
  e.u = area(c, b);
  e.v = area(a, c);
  e.w = area(b, a);
  e.u_neg = e.u - !u_up < 0;
  e.v_neg = e.v - !v_up < 0;
  e.w_neg = e.w - !w_up < 0;
  e.point = !(u_up | v_up | w_up);
  return e;
}

}  // namespace castray
