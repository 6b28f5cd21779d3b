// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/shade/shade.sv: the colour of a hit. `hit` is found; a miss goes to background().
#pragma once
#include "fixed.hpp"
#include "isect/corner_delta.hpp"
#include "shade/interpolate.hpp"
#include "shade/normalise.hpp"
#include "shade/paint.hpp"
#include "shade/sphere_normal.hpp"

namespace castray {

// The ray's direction up to its length and sign, which shading does not need.
inline span3_t view_of(const hit_t& hit) {
  const delta3_t d = unpermute({hit.sx, hit.sy, std::int64_t{1} << ShearFrac}, hit.axis);
  span3_t out;
  out.x = d.x;
  out.y = d.y;
  out.z = d.z;
  return out;
}

inline paint_req_t shade_vectors(const hit_t& hit, const attr_t& attr, const point_t& eye) {
  paint_req_t req;
  span3_t normal;
  if (hit.kind == static_cast<std::uint64_t>(KindSphere)) {
    normal = sphere_normal(hit, attr.centre, eye);
  } else {
    const smooth_t smooth = interpolate(attr, hit.u, hit.v);
    normal = smooth.normal;
    req.s = smooth.s;
    req.t = smooth.t;
  }
  const span3_t view = view_of(hit);
  req.tag = hit.tag;
  req.kind = hit.kind;
  req.material = attr.material;
  req.normal = normalise(normal.x, normal.y, normal.z);
  req.view = normalise(view.x, view.y, view.z);
  return req;
}

inline shaded_t shade(const hit_t& hit, const attr_t& attr, const point_t& eye, const paint_t& paint_params) {
  return paint(shade_vectors(hit, attr, eye), paint_params);
}

}  // namespace castray
