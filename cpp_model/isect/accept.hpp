// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/isect/accept.sv: does the ray pass through the triangle?
#pragma once
#include "isect/edge_fns.hpp"

namespace castray {

// All three signs equal and det = U + V + W not zero. Zeros take their sign from a strict order of
// the corners around the triangle, so all three can be zero with equal signs only where the
// corners coincide: det is zero with equal signs exactly if `point`.
// Seen from the ray's origin the front (counter-clockwise) has det > 0 for a ray along +z.
inline bool accept(const edge_fns_t& e, bool neg, bool cull) {
  return bool((e.u_neg == e.v_neg) & (e.v_neg == e.w_neg) & !e.point & !(cull & (e.u_neg != neg)));
}

}  // namespace castray
