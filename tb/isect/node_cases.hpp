// SPDX-License-Identifier: Apache-2.0
// Seeded nodes and rays that pass their children's boxes closely, and what of a box a ray must visit.
#pragma once
#include "box_oracle.hpp"
#include "camera/slab_setup.hpp"

namespace castray::tb {

// What a box may be dropped by at least, in units of t: 129 of 16, docs/number-formats.md.
inline constexpr std::int64_t kBoxMarginT = ((std::int64_t{1} << (CoordW + 1 + TFrac)) >> BaryFrac) + 1;

struct NodeCase {
  slab_ray_t ray;
  shear_t sx = 0, sy = 0;
  node_t node;
  t_t t = TMax;
  ctx_t ctx = 0;
};

inline void set_shear(NodeCase& c, shear_t sx, shear_t sy) {
  c.sx = sx, c.sy = sy;
  c.ray.rx = recip_of(sx), c.ray.ry = recip_of(sy);
}

inline ref_word_t any_ref(Rng& rng) {
  return static_cast<ref_word_t>(rng.in(RefNode, RefLeaf) << LineW | rng.in(0, (1 << LineW) - 1));
}

inline child_box_t any_box(Rng& rng) {
  const auto pair = [&](plane_t& low, plane_t& high) {
    low = static_cast<plane_t>(rng.chance(8) ? 0 : rng.in(0, 255));
    high = static_cast<plane_t>(rng.chance(8) ? 255 : rng.chance(8) ? low : rng.in(0, 255));
    if (low > high && !rng.chance(50)) std::swap(low, high);
  };
  child_box_t box;
  pair(box.x0, box.x1), pair(box.y0, box.y1), pair(box.z0, box.z1);
  return box;
}

inline node_t any_node(Rng& rng) {
  const std::int64_t scale = rng.in(0, MaxPlaneExp);
  const auto exp = [&] { return static_cast<plane_exp_t>(std::clamp<std::int64_t>(scale + rng.in(-4, 4) * rng.chance(2), 0, MaxPlaneExp)); };
  node_t node;
  node.x = rng.coord(), node.y = rng.coord(), node.z = rng.coord();
  node.exp_x = exp(), node.exp_y = exp(), node.exp_z = exp();
  node.box0 = any_box(rng), node.box1 = any_box(rng), node.box2 = any_box(rng), node.box3 = any_box(rng);
  const std::int64_t children = rng.chance(4) ? rng.in(1, 4) : 4;
  node.ref0 = any_ref(rng);
  if (children > 1) node.ref1 = any_ref(rng);
  if (children > 2) node.ref2 = any_ref(rng);
  if (children > 3) node.ref3 = any_ref(rng);
  return node;
}

inline shear_t slab_shear(Rng& rng) {
  const std::int64_t power = std::int64_t{1} << rng.in(0, ShearFrac - 1);
  switch (rng.in(0, 7)) {
    case 0: return power;
    case 1: return -power;
    case 2: return rng.in(-power, power);
    default: return rng.shear();
  }
}

// A node, and a ray that runs through or just past a corner, an edge or a face of one of its boxes; its
// t and tmin random, or close to where that is.
inline NodeCase random_node_case(Rng& rng) {
  NodeCase c;
  c.node = any_node(rng);
  c.ctx = static_cast<ctx_t>(rng.in(0, 63));
  c.ray.axis = static_cast<axis_t>(rng.in(0, 2));
  c.ray.neg = rng.chance(2);
  c.ray.org = rng.point();
  set_shear(c, slab_shear(rng), slab_shear(rng));

  const Box box = box_of(c.node, static_cast<int>(rng.in(0, 3)), c.ray);
  const auto place = [&](std::int64_t low, std::int64_t high) {
    const std::int64_t at = rng.chance(2) ? rng.in(std::min(low, high), std::max(low, high)) : rng.chance(2) ? low : high;
    return at + (rng.chance(3) ? rng.in(-2, 2) : 0);
  };
  const delta3_t point = {place(box.low.x, box.high.x), place(box.low.y, box.high.y), place(box.low.z, box.high.z)};
  std::int64_t z = 0;
  for (int attempt = 0; attempt < 8; ++attempt) {
    z = rng.in(-1, 1) * (rng.in(0, kGrid - 1) >> rng.in(0, CoordW - 1));
    if (rng.chance(2)) z &= -(std::int64_t{1} << rng.in(0, CoordW - 1));   // then S z may be whole
    const delta3_t from = {point.x - ((c.sx * z) >> ShearFrac), point.y - ((c.sy * z) >> ShearFrac), point.z - z};
    const std::int64_t org[] = {static_cast<std::int64_t>(c.ray.org.x) + from.x, static_cast<std::int64_t>(c.ray.org.y) + from.y,
                                static_cast<std::int64_t>(c.ray.org.z) + from.z};
    if (std::any_of(org, org + 3, [](std::int64_t x) { return x < 0 || x >= 2 * kHalf; })) continue;
    c.ray.org.x = static_cast<coord_t>(org[0]), c.ray.org.y = static_cast<coord_t>(org[1]), c.ray.org.z = static_cast<coord_t>(org[2]);
    break;
  }
  const std::int64_t at = std::clamp<std::int64_t>((c.ray.neg ? -z : z) * (1 << TFrac) + rng.in(-300, 300), -TMax, TMax);
  c.t = rng.chance(3) ? at : rng.chance(8) ? rng.in(-TMax, TMax) : TMax;
  c.ray.tmin = rng.chance(4) ? std::min<std::int64_t>(at, c.t) : rng.chance(3) ? -TMax : rng.chance(8) ? rng.in(-TMax, c.t) : 0;
  return c;
}

// Where the line is inside the box and a hit could still be of use: t between tmin and the nearest,
// moved apart by `margin` sixteenths of a step.
inline Stretch useful(const NodeCase& c, int child, std::int64_t margin) {
  Stretch z = inside(c.sx, c.sy, box_of(c.node, child, c.ray));
  const int128 from = c.ray.tmin - margin, to = c.t + margin, one = 1 << TFrac;
  c.ray.neg ? z.clip(Fraction{-to, one}, Fraction{-from, one}) : z.clip(Fraction{from, one}, Fraction{to, one});
  return z;
}

inline const entry_t& entry(const visits_t& visits, int place) {
  const entry_t* const entries[] = {&visits.e0, &visits.e1, &visits.e2, &visits.e3};
  return *entries[place];
}
inline bool visited(const visits_t& visits, const node_t& node, int child) {
  for (int i = 0; i < 4; ++i) {
    const entry_t& e = entry(visits, i);
    if (e.target.kind != RefNone && (e.target.kind << LineW | e.target.index) == child_ref(node, child)) return true;
  }
  return false;
}

inline std::string to_text(const NodeCase& c) {
  return "ray  " + castray::to_text(c.ray) + "\nS    " + std::to_string(c.sx) + " " + std::to_string(c.sy) + "\nnode " +
         castray::to_text(c.node) + "\nt    " + std::to_string(c.t);
}

}  // namespace castray::tb
