// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The primitive pipe: RTL = model = the plain definition, ties, extremes, culling.
#include "ray_prim_meshes.hpp"
#include "ray_prim_spheres.hpp"

namespace castray::tb {
namespace {

// Acceptance by the words of the definition: signs of zeros from two differences, det not zero.
int sign(int128 x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
bool plain_accept(const PrimCase& t) {
  int128 x[3], y[3];
  const point_t* corners[3] = {&t.prim.a, &t.prim.b, &t.prim.c};
  for (int i = 0; i < 3; ++i) {
    const point_t& p = *corners[i];
    const std::int64_t at[3] = {std::int64_t(p.x), std::int64_t(p.y), std::int64_t(p.z)};
    const int k = static_cast<int>(t.ray.axis);   // the dominant axis; the origin's comes last
    std::int64_t d[3];
    d[k] = at[k] - std::int64_t(t.ray.org.z);
    d[(k + 1) % 3] = at[(k + 1) % 3] - std::int64_t(t.ray.org.x);
    d[(k + 2) % 3] = at[(k + 2) % 3] - std::int64_t(t.ray.org.y);
    const int128 z = d[k];
    x[i] = ((int128{d[(k + 1) % 3]} << ShearFrac) - t.ray.sx * z + kOne) >> (ShearFrac + 1);
    y[i] = ((int128{d[(k + 2) % 3]} << ShearFrac) - t.ray.sy * z + kOne) >> (ShearFrac + 1);
  }
  const auto side = [&](int p, int q, int128& area) {  // of the edge between corners p and q
    area = x[p] * y[q] - y[p] * x[q];
    return area != 0 ? sign(area) : y[p] != y[q] ? sign(y[p] - y[q]) : sign(x[q] - x[p]);
  };
  int128 u, v, w;
  const int su = side(2, 1, u), sv = side(0, 2, v), sw = side(1, 0, w);
  const int128 det = u + v + w;
  const bool front = t.ray.neg ? det < 0 : det > 0;
  return su != 0 && su == sv && sv == sw && det != 0 && (front || !t.ray.cull) && t.prim.number != NoPrim;
}

// Every triangle with corners among 5 x 5 places around the ray: all ties there are.
std::vector<PrimCase> lattice(int spread) {
  std::vector<PrimCase> cases;
  const auto at = [&](int i) { return delta3_t{2 * (i % 5 - 2), 2 * (i / 5 - 2), (i * 7) % spread}; };
  for (int a = 0; a < 25; ++a)
    for (int b = 0; b < 25; ++b)
      for (int c = 0; c < 25; ++c) cases.push_back(triangle(straight_ray(), at(a), at(b), at(c)));
  return cases;
}

}  // namespace

class RayPrimStalls : public ::testing::TestWithParam<Stalls> {};
INSTANTIATE_TEST_SUITE_P(All, RayPrimStalls, ::testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(RayPrimStalls, MatchesModel) {
  Rng rng(11);
  std::vector<PrimCase> cases;
  for (int i = 0; i < 60000; ++i) cases.push_back(random_case(rng));
  const Sent sent = run(cases, GetParam(), 3);
  EXPECT_GT(sent.accepted, 6000);
  EXPECT_GT(sent.missed, 6000);
}

TEST(RayPrim, ModelIsThePlainDefinition) {
  Rng rng(12);
  int accepted = 0;
  for (int i = 0; i < 300000; ++i) {
    const PrimCase c = random_case(rng);
    if (c.prim.kind == KindSphere) continue;
    const bool want = plain_accept(c);
    accepted += want;
    ASSERT_EQ(hits(c), want) << to_text(c.ray) << "\n" << to_text(c.prim);
  }
  EXPECT_GT(accepted, 15000);
  for (const PrimCase& c : lattice(5)) ASSERT_EQ(hits(c), plain_accept(c)) << to_text(c.prim);
}

TEST(RayPrim, DecidesEveryTie) { run(lattice(9)); }

// The ray goes exactly through an edge or a corner: named cases of each edge and each fallback.
TEST(RayPrim, ZeroOfEachEdgeGoesToItsSide) {
  // An edge across the ray with the triangle on either side; two directions of it: one decided by
  // the difference in y, one (the edge lies along x) by the difference in x.
  const delta3_t ends[2][2] = {{{0, -20, 5}, {0, 20, 9}}, {{-20, 0, 5}, {20, 0, 9}}};
  const delta3_t sides[2][2] = {{{30, 2, 3}, {-30, 2, 3}}, {{2, 30, 3}, {2, -30, 3}}};
  for (int along = 0; along < 2; ++along) {
    for (int rotate = 0; rotate < 3; ++rotate) {  // the edge is opposite A, B or C
      int owners = 0;
      for (int side = 0; side < 2; ++side) {
        delta3_t k[3] = {sides[along][side], ends[along][side], ends[along][1 - side]};
        std::rotate(k, k + rotate, k + 3);
        const PrimCase t = triangle(straight_ray(), k[0], k[1], k[2]);
        owners += hits(t);
        EXPECT_EQ(hits(t), plain_accept(t));
        run({t});
      }
      EXPECT_EQ(owners, 1) << "along " << along << " rotate " << rotate;
    }
  }
  // A fan of eight triangles around a corner on the ray: one owner.
  const delta3_t rim[8] = {{20, 0, 1}, {20, 20, 2}, {0, 20, 3}, {-20, 20, 4}, {-20, 0, 5}, {-20, -20, 6}, {0, -20, 7}, {20, -20, 8}};
  for (int rotate = 0; rotate < 3; ++rotate) {
    std::vector<PrimCase> fan;
    for (int i = 0; i < 8; ++i) {
      delta3_t k[3] = {{0, 0, 4}, rim[i], rim[(i + 1) % 8]};
      std::rotate(k, k + rotate, k + 3);
      fan.push_back(triangle(straight_ray(), k[0], k[1], k[2]));
    }
    EXPECT_EQ(run(fan).accepted, 1);
  }
}

TEST(RayPrim, DegenerateTrianglesAreMissed) {
  const delta3_t o{0, 0, 5}, p{10, 4, 6}, q{-10, -4, 7}, r{20, 8, 1};
  std::vector<PrimCase> cases;
  for (const delta3_t& a : {o, p, q, r})
    for (const delta3_t& b : {o, p, q, r})
      for (const delta3_t& c : {o, p, q, r}) cases.push_back(triangle(straight_ray(), a, b, c));
  EXPECT_EQ(run(cases).accepted, 0);
}

TEST(RayPrim, RoundsShearedCornersHalfUp) {
  // Straight ray: X is x / 2. Corners at odd places: 1 -> 1, -1 -> 0, 3 -> 2, -3 -> -1.
  const PrimCase t = triangle(straight_ray(), {-3, -1, 2}, {3, -1, 3}, {1, 3, 4});
  const cand_t cand = cand_of(t);  // sheared: (-1,0) (2,0) (1,2)
  EXPECT_EQ(cand.det, 6u);
  EXPECT_EQ(cand.u, 4u);
  EXPECT_EQ(cand.v, 2u);
  run({t});
  // The same tie made by the product: x - s z = 1 - 1/2 * 2 z.
  test_ray_t ray = straight_ray();
  ray.sx = ray.sy = kOne / 2;
  run({triangle(ray, {-3 + 3, -1 + 3, 6}, {3 + 5, -1 + 5, 10}, {1 + 7, 3 + 7, 14})});
}

TEST(RayPrim, ReachesEveryExtreme) {
  std::vector<PrimCase> cases;
  const std::uint64_t ends[3] = {0, kGrid - 1, (1u << CoordW) - 1};
  const std::int64_t shears[3] = {kOne - 1, 1 - kOne, 0};
  Rng rng(5);
  const auto any = [&](int n) { return static_cast<int>(rng.in(0, n - 1)); };
  const auto corner = [&] {
    point_t p;
    p.x = ends[any(3)], p.y = ends[any(3)], p.z = ends[any(3)];
    return p;
  };
  for (int i = 0; i < 50000; ++i) {
    PrimCase c;
    c.ray.org = corner();
    c.ray.sx = shears[any(3)], c.ray.sy = shears[any(3)];
    c.ray.norm2 = norm2_of(c.ray.sx, c.ray.sy);
    c.ray.axis = static_cast<axis_t>(any(3)), c.ray.neg = any(2);
    c.prim.a = corner(), c.prim.b = corner(), c.prim.c = corner();
    c.prim.number = static_cast<prim_t>(any(2) ? 0 : NoPrim - 1);
    c.prim.kind = static_cast<std::uint64_t>(any(2));
    if (c.prim.kind == KindSphere) c.prim.b.x = static_cast<std::uint64_t>(any(2) ? kHalf - 1 : kHalf - any(9));
    c.ctx = static_cast<ctx_t>(any(64));
    cases.push_back(c);
  }
  EXPECT_GT(run(cases).accepted, 1000);
}

// Front: counter-clockwise seen from the ray's origin, by cross products of the corners themselves.
TEST(RayPrim, CullsBackFaces) {
  Rng rng(21);
  int fronts = 0, backs = 0;
  std::vector<PrimCase> some;
  for (int i = 0; i < 200000; ++i) {
    PrimCase c = random_case(rng);
    c.ray.cull = 0;
    if (c.prim.kind == KindSphere || !hits(c)) continue;
    const auto world = [&](const point_t& p, const point_t& q, double* d) {
      d[0] = double(p.x) - double(q.x), d[1] = double(p.y) - double(q.y), d[2] = double(p.z) - double(q.z);
    };
    double e[3], f[3];
    world(c.prim.b, c.prim.a, e);
    world(c.prim.c, c.prim.a, f);
    const double n[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    const int k = static_cast<int>(c.ray.axis);
    const double along = c.ray.neg ? -1 : 1;
    const double facing = along * (n[(k + 1) % 3] * double(c.ray.sx) / double(kOne) +
                                   n[(k + 2) % 3] * double(c.ray.sy) / double(kOne) + n[k]);
    // Near edge-on the rounding of the sheared corners may turn a triangle over: left out.
    const double edges = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    if (std::abs(facing) < 8 * edges + 64) continue;
    c.ray.cull = 1;
    ASSERT_EQ(hits(c), facing < 0) << to_text(c.ray) << "\n" << to_text(c.prim);
    ++(facing < 0 ? fronts : backs);
    if (some.size() < 2000) some.push_back(c);
  }
  EXPECT_GT(fronts, 5000);
  EXPECT_GT(backs, 5000);
  run(some);
}

TEST(RayPrim, EmptySlotIsNeverAccepted) {
  PrimCase t = triangle(straight_ray(), {-50, -50, 9}, {50, -50, 9}, {0, 50, 9});
  EXPECT_TRUE(hits(t));
  PrimCase s = sphere(straight_ray(), {0, 0, 9}, 30);
  std::vector<PrimCase> cases{t, s};
  t.prim.number = s.prim.number = NoPrim;
  cases.insert(cases.end(), {t, s, t});
  EXPECT_EQ(run(cases).accepted, 2);
}

TEST(RayPrim, EveryStageHoldsAnAcceptedTest) {
  // Triangles and spheres in turn, no gaps, all accepted: each result in its own cycle.
  std::vector<PrimCase> cases;
  Rng rng(77);
  for (int i = 0; i < 500; ++i) {
    test_ray_t ray = rng.ray();
    ray.cull = 0;
    PrimCase t = triangle(ray, {-900, -800, 0}, {900 + i, -800, 2}, {i, 900, 1});
    t.ray.org.x = t.ray.org.y = t.ray.org.z = kHalf;
    t.prim.a = at_delta(t.ray, {-900, -800, 0}), t.prim.b = at_delta(t.ray, {900 + i, -800, 2}), t.prim.c = at_delta(t.ray, {i, 900, 1});
    t.ctx = static_cast<ctx_t>(i % 64);
    t.prim.number = static_cast<prim_t>(i);
    PrimCase s = t;
    s.prim.kind = KindSphere;
    s.prim.b.x = static_cast<std::uint64_t>(5000 + i);
    cases.insert(cases.end(), {t, s});
    if (i % 3 == 0) cases.push_back(t);
    if (i % 7 == 0) cases.push_back(s);
  }
  EXPECT_EQ(run(cases).missed, 0);
}

TEST(RayPrim, ResetEmptiesThePipe) {
  Dut<Vray_prim> dut;
  const PrimCase t = triangle(straight_ray(), {-50, -50, 9}, {50, -50, 9}, {0, 50, 9});
  const PrimCase s = sphere(straight_ray(), {0, 0, 9}, 30);
  for (int i = 0; i < kLatency; ++i) {
    dut->in_valid_i = 1;
    set_port(dut->in_ray_i, t.ray);
    set_port(dut->in_prim_i, i % 2 ? t.prim : s.prim);
    dut.tick();
  }
  dut->in_valid_i = 0;
  dut.reset(1);
  for (int i = 0; i < 2 * kLatency; ++i) {
    dut.settle();
    EXPECT_FALSE(dut->out_valid_o || dut->retire_o);
    dut.tick();
  }
}

}  // namespace castray::tb
