// SPDX-License-Identifier: Apache-2.0
// Which children of a node a ray visits, near ones first. RTL: rtl/isect/node_pipe.sv, equal bit for
// bit; docs/number-formats.md, "The test of a node", shows that no child is dropped that holds a hit.
#pragma once
#include "isect/corner_delta.hpp"
#include "isect/node_order.hpp"
#include "isect/slab_child.hpp"
#include "isect/slab_limits.hpp"

namespace castray {

// Is the node one that a scene image may hold, as far as the node itself can tell?
inline bool node_legal(const node_t& node) {
  bool ended = false;
  for (const ref_word_t word : {node.ref0, node.ref1, node.ref2, node.ref3}) {
    const bool none = word == 0;
    const std::uint64_t kind = word >> LineW;
    if (!none && (ended || (kind != RefNode && kind != RefLeaf))) return false;
    ended = none;
  }
  return node.exp_x <= MaxPlaneExp && node.exp_y <= MaxPlaneExp && node.exp_z <= MaxPlaneExp;
}

// t: the nearest hit so far. Of an illegal node no child is visited.
inline visits_t node_pipe(const slab_ray_t& ray, const node_t& node, t_t t, bool& illegal) {
  illegal = !node_legal(node);
  if (illegal) return {};

  const auto planes = [&](plane_t x, plane_t y, plane_t z) {
    return permute({static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), static_cast<std::int64_t>(z)}, ray.axis);
  };
  point_t origin;
  origin.x = node.x, origin.y = node.y, origin.z = node.z;
  const delta3_t d = corner_delta(origin, ray.org, ray.axis);
  const delta3_t exps = planes(node.exp_x, node.exp_y, node.exp_z);
  const int ez = static_cast<int>(exps.z);
  const slab_axis_t x = slab_axis(ray.rx, d.x, static_cast<int>(exps.x), d.z, ez);
  const slab_axis_t y = slab_axis(ray.ry, d.y, static_cast<int>(exps.y), d.z, ez);
  const span_ticks_t limits = slab_limits(ray.tmin, t, ray.neg, d.z, ez);

  const child_box_t* const boxes[] = {&node.box0, &node.box1, &node.box2, &node.box3};
  const ref_word_t words[] = {node.ref0, node.ref1, node.ref2, node.ref3};
  std::array<child_t, 4> children;
  for (int i = 0; i < 4 && words[i] != 0; ++i) {
    const delta3_t q0 = planes(boxes[i]->x0, boxes[i]->y0, boxes[i]->z0);
    const delta3_t q1 = planes(boxes[i]->x1, boxes[i]->y1, boxes[i]->z1);
    children[i].exists = true;
    children[i].inside = slab_child(x, y, {q0.x, q1.x, q0.y, q1.y, q0.z, q1.z});
    children[i].target.kind = words[i] >> LineW;
    children[i].target.index = words[i] & ((std::uint64_t{1} << LineW) - 1);
  }
  return node_order(children, limits, d.z, ez, ray.neg);
}

}  // namespace castray
