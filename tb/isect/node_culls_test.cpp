// SPDX-License-Identifier: Apache-2.0
// What the node test drops: never a box through which the line passes where a hit could be of use,
// and never one with a primitive that the exact test hits; seldom less than exact arithmetic would.
// A million boxes, or as many as CASTRAY_PAIRS says, and a fifth as many primitives.
// Long: CASTRAY_PAIRS=50000000 --gtest_filter=NodeCulls.No*
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "isect/hit_unit.hpp"
#include "node_cases.hpp"
#include "scene/box.hpp"

namespace castray::tb {
namespace {

long pairs() {
  const char* text = std::getenv("CASTRAY_PAIRS");
  return text ? std::atol(text) : 1000000;
}

// The first t of a stretch.
Fraction entry_t_of(const Stretch& z, bool neg) { return neg ? Fraction{-z.last.num, z.last.den} : z.first; }

TEST(NodeCulls, NoBoxThatTheLinePassesThrough) {
  Rng rng(81);
  long seen = 0, passed = 0, zero = 0, inside_box = 0, behind = 0;
  while (seen < pairs()) {
    const NodeCase c = random_node_case(rng);
    bool illegal = false;
    const visits_t visits = node_pipe(c.ray, c.node, c.t, illegal);
    ASSERT_FALSE(illegal);
    for (int child = 0; child < 4; ++child) {
      if (child_ref(c.node, child) == 0) continue;
      ++seen;
      const Stretch z = useful(c, child, kBoxMarginT);
      if (z.empty) continue;
      ++passed;
      zero += c.sx == 0 || c.sy == 0;
      inside_box += z.first < Fraction{0} && Fraction{0} < z.last;
      behind += c.ray.tmin < 0;
      ASSERT_TRUE(visited(visits, c.node, child)) << "child " << child << "\n" << to_text(c);
    }
  }
  std::printf("%ld of %ld boxes passed through: %ld with a zero component, %ld from inside, %ld with a negative tmin; none dropped\n",
              passed, seen, zero, inside_box, behind);
  EXPECT_GT(passed, seen / 20);
  EXPECT_GT(zero, seen / 100);
  EXPECT_GT(inside_box, seen / 200);
}

// A child's least is not above the t at which the line enters its box, less the margin.
TEST(NodeCulls, NeverLaterThanTheEntry) {
  Rng rng(82);
  constexpr int kShift = CoordW + TFrac - DistW;
  long seen = 0;
  for (int i = 0; i < 200000; ++i) {
    const NodeCase c = random_node_case(rng);
    bool illegal = false;
    const visits_t visits = node_pipe(c.ray, c.node, c.t, illegal);
    for (int child = 0; child < 4; ++child) {
      const Stretch z = inside(c.sx, c.sy, box_of(c.node, child, c.ray));
      if (z.empty) continue;
      const Fraction enters = entry_t_of(z, c.ray.neg);
      for (int place = 0; place < 4; ++place) {
        const entry_t& e = entry(visits, place);
        if (e.target.kind == RefNone || (e.target.kind << LineW | e.target.index) != child_ref(c.node, child) || e.least == 0) continue;
        ++seen;
        // least 2^14 <= enters - 129/16, in sixteenths
        const Fraction least{(int128{static_cast<std::int64_t>(e.least)} << kShift) + kBoxMarginT, 1 << TFrac};
        ASSERT_FALSE(enters < least) << "child " << child << " least " << e.least << "\n" << to_text(c);
      }
    }
  }
  EXPECT_GT(seen, 10000);
}

// A box on the grid of a random node that holds it: outwards.
struct Placed {
  std::uint64_t origin, exp, low, high;
};
Placed place(Rng& rng, std::int64_t low, std::int64_t high) {
  Placed p;
  const std::int64_t room = std::min(low, std::int64_t{1} << rng.in(0, CoordW - 1));
  p.origin = static_cast<std::uint64_t>(rng.in(low - room, low));
  p.exp = 0;
  while (static_cast<std::int64_t>(p.origin + (255u << p.exp)) < high) ++p.exp;
  if (rng.chance(2)) p.exp = std::min<std::uint64_t>(p.exp + static_cast<std::uint64_t>(rng.in(0, 4)), MaxPlaneExp);
  p.low = (static_cast<std::uint64_t>(low) - p.origin) >> p.exp;
  p.high = (static_cast<std::uint64_t>(high) - p.origin + (1u << p.exp) - 1) >> p.exp;
  return p;
}

TEST(NodeCulls, NoPrimitiveThatTheExactTestHits) {
  Rng rng(83);
  long tested = 0, spheres = 0;
  while (tested < pairs() / 5) {
    PrimCase p = random_case(rng);
    for (point_t* const point : {&p.ray.org, &p.prim.a, &p.prim.b, &p.prim.c}) {
      if (p.prim.kind == KindSphere && point == &p.prim.b) continue;
      point->x += 32, point->y += 32, point->z += 32;   // as the host's grid has it
    }
    cand_t cand;
    if (!ray_prim(p.ray, p.prim, 0, cand)) continue;
    hit_ray_t hit_ray;
    hit_ray.norm2 = p.ray.norm2, hit_ray.neg = p.ray.neg, hit_ray.cull = p.ray.cull;
    hit_ray.tmin = rng.chance(4) ? 0 : rng.chance(4) ? rng.in(-TMax, TMax) : -TMax - 1;
    result_t hit;
    if (!hit_unit(cand, hit_ray, hit)) continue;
    const castray::Box box = padded_box(p.prim);
    bool outside = false;   // a large sphere: not in a scene
    for (int k = 0; k < 3; ++k) outside = outside || box.low[k] < 0 || box.high[k] > 2 * kHalf - 1;
    if (outside) continue;

    NodeCase c;
    c.ray.org = p.ray.org, c.ray.axis = p.ray.axis, c.ray.neg = p.ray.neg;
    c.ray.tmin = rng.chance(3) ? hit.t - 1 : hit_ray.tmin;
    set_shear(c, p.ray.sx, p.ray.sy);
    c.t = hit.t;
    const Placed x = place(rng, box.low[0], box.high[0]), y = place(rng, box.low[1], box.high[1]), z = place(rng, box.low[2], box.high[2]);
    c.node.x = x.origin, c.node.y = y.origin, c.node.z = z.origin;
    c.node.exp_x = x.exp, c.node.exp_y = y.exp, c.node.exp_z = z.exp;
    c.node.ref0 = RefLeaf << LineW | 5;
    c.node.box0 = {.x0 = x.low, .y0 = y.low, .z0 = z.low, .x1 = x.high, .y1 = y.high, .z1 = z.high};
    bool illegal = false;
    const visits_t visits = node_pipe(c.ray, c.node, c.t, illegal);
    ++tested;
    spheres += p.prim.kind == KindSphere;
    ASSERT_FALSE(illegal);
    ASSERT_TRUE(visited(visits, c.node, 0)) << to_text(c) << "\nprim " << castray::to_text(p.prim);
    ASSERT_LE(visits.e0.least, dist_of(hit.t)) << to_text(c) << "\nprim " << castray::to_text(p.prim);
  }
  std::printf("%ld primitives hit, %ld of them spheres; none of their boxes dropped\n", tested, spheres);
  EXPECT_GT(spheres, tested / 20);
}

// Four halves of halves of a box, each a little smaller than its share, on the node's own grid; extents
// of up to `reach` steps.
node_t four_parts(Rng& rng, std::int64_t reach) {
  std::int64_t low[4][3] = {}, high[4][3], extent[3], origin[3];
  int exp[3] = {};
  for (int k = 0; k < 3; ++k) {
    extent[k] = rng.in(reach / 4, reach);
    origin[k] = rng.in(0, kGrid - extent[k]);
    while ((std::int64_t{255} << exp[k]) < extent[k]) ++exp[k];
    for (auto& h : high) h[k] = extent[k];
  }
  const auto halve = [&](int from, int to) {
    int k = 0;
    for (int j = 1; j < 3; ++j)
      if (high[from][j] - low[from][j] > high[from][k] - low[from][k]) k = j;
    const std::int64_t middle = (low[from][k] + high[from][k]) / 2;
    for (int c = from; c < to; ++c) (c < (from + to) / 2 ? high[c][k] : low[c][k]) = middle;
  };
  halve(0, 4), halve(0, 2), halve(2, 4);
  child_box_t boxes[4];
  for (int c = 0; c < 4; ++c) {
    plane_t q[2][3];
    for (int k = 0; k < 3; ++k) {
      const std::int64_t width = high[c][k] - low[c][k];
      q[0][k] = static_cast<plane_t>((low[c][k] + rng.in(0, width / 5)) >> exp[k]);
      q[1][k] = static_cast<plane_t>((high[c][k] - rng.in(0, width / 5) + (1 << exp[k]) - 1) >> exp[k]);
    }
    boxes[c] = {.x0 = q[0][0], .y0 = q[0][1], .z0 = q[0][2], .x1 = q[1][0], .y1 = q[1][1], .z1 = q[1][2]};
  }
  node_t node;
  node.x = static_cast<coord_t>(origin[0]), node.y = static_cast<coord_t>(origin[1]), node.z = static_cast<coord_t>(origin[2]);
  node.exp_x = static_cast<plane_exp_t>(exp[0]), node.exp_y = static_cast<plane_exp_t>(exp[1]), node.exp_z = static_cast<plane_exp_t>(exp[2]);
  node.box0 = boxes[0], node.box1 = boxes[1], node.box2 = boxes[2], node.box3 = boxes[3];
  node.ref0 = RefLeaf << LineW, node.ref1 = node.ref0 + 1, node.ref2 = node.ref0 + 2, node.ref3 = node.ref0 + 3;
  return node;
}

// A ray from anywhere through a point of the node.
NodeCase through(Rng& rng, const node_t& node) {
  NodeCase c;
  c.node = node;
  c.ray.org = rng.point();
  const auto towards = [&](coord_t from, plane_exp_t exp, coord_t org) {
    return static_cast<std::int64_t>(from) + (rng.in(0, 255) << exp) - static_cast<std::int64_t>(org);
  };
  const delta3_t d = {towards(node.x, node.exp_x, c.ray.org.x), towards(node.y, node.exp_y, c.ray.org.y), towards(node.z, node.exp_z, c.ray.org.z)};
  const std::int64_t x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  c.ray.axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  c.ray.org = permuted(c.ray.org, c.ray.axis);
  const delta3_t p = permute(d, c.ray.axis);
  c.ray.neg = p.z < 0;
  const auto shear = [&](std::int64_t k) { return p.z == 0 ? 0 : std::clamp((k << ShearFrac) / p.z, 1 - kOne, kOne - 1); };
  set_shear(c, shear(p.x), shear(p.y));
  return c;
}

TEST(NodeCulls, SeldomLessThanExactArithmetic) {
  Rng rng(84);
  for (int reach = CoordW - 12; reach < static_cast<int>(CoordW); reach += 2) {
    long kept = 0, exact = 0;
    for (int i = 0; i < 30000; ++i) {
      const NodeCase c = through(rng, four_parts(rng, std::int64_t{1} << reach));
      bool illegal = false;
      const visits_t visits = node_pipe(c.ray, c.node, c.t, illegal);
      for (int child = 0; child < 4; ++child) {
        kept += visited(visits, c.node, child);
        exact += !useful(c, child, kBoxMarginT).empty;
      }
    }
    const double more = 100.0 * static_cast<double>(kept - exact) / static_cast<double>(kept);
    std::printf("nodes of up to 2^%d steps: %.2f%% of the boxes visited would be dropped by exact arithmetic\n", reach, more);
    EXPECT_LT(more, reach >= static_cast<int>(CoordW) - 6 ? 1.0 : reach >= static_cast<int>(CoordW) - 10 ? 2.5 : 10.0);
    EXPECT_GE(kept, exact);
    EXPECT_GT(kept, 10000);
  }
}

}  // namespace
}  // namespace castray::tb
