// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The hit unit: RTL = model, normalisation, rounding, roots, throughput.
#include "hit_unit_run.hpp"

namespace castray::tb {

class HitUnitStalls : public ::testing::TestWithParam<Stalls> {};
INSTANTIATE_TEST_SUITE_P(All, HitUnitStalls, ::testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(HitUnitStalls, MatchesModelOnWhatThePipeAccepts) {
  const Outcome r = run(accepted_cases(15000, 31), GetParam(), 2);
  EXPECT_GT(r.out.size(), 3000u);
}
TEST_P(HitUnitStalls, MatchesModelOnAnyMagnitude) {
  Rng rng(32);
  std::vector<HitCase> cases;
  for (int i = 0; i < 20000; ++i) cases.push_back(any_triangle(rng));
  EXPECT_GT(run(cases, GetParam(), 3).out.size(), 3000u);
}

TEST(HitUnit, NormalisesEitherWay) {
  // The same quotients from det of 1 bit to all its bits: shifted left, not at all, right.
  for (int k = 2; k <= 2 * CoordW + 2; ++k) {
    const std::uint64_t unit = std::uint64_t{1} << (k - 2);
    const result_t r = one(triangle(unit, 2 * unit, 4 * unit, 400, 800, 1200));
    EXPECT_EQ(r.u, 1u << (BaryFrac - 2)) << k;
    EXPECT_EQ(r.v, 1u << (BaryFrac - 1)) << k;
    EXPECT_EQ(r.t, (400 / 4 + 800 / 2 + 1200 / 4) * kStep) << k;
  }
  // Right shifts truncate: det = 2^HitDivW + 1 counts as 2^HitDivW, u = 3 as 2 of it.
  EXPECT_EQ(one(triangle((2 << kGain) + 1, 0, (1 << HitDivW) + 1, 0, 0, 0)).u, 1u);
}

TEST(HitUnit, CornersAreExact) {
  for (std::uint64_t det : {1ull, 77ull, (1ull << HitDivW) + 12345, (1ull << (2 * CoordW + 2)) - 1}) {
    const result_t a = one(triangle(det, 0, det, 123, -456, 789)), b = one(triangle(0, det, det, 123, -456, 789)),
                   c = one(triangle(0, 0, det, 123, -456, 789));
    EXPECT_EQ(a.u, 1u << BaryFrac);
    EXPECT_EQ(b.v, 1u << BaryFrac);
    EXPECT_EQ(a.t, 123 * kStep);
    EXPECT_EQ(b.t, -456 * kStep);
    EXPECT_EQ(c.t, 789 * kStep);
    EXPECT_EQ(c.u + c.v + a.v + b.u, 0u);
  }
  const std::int64_t far = kGrid - 1;
  EXPECT_EQ(one(triangle(9, 0, 9, far, -far, 0)).t, far * kStep);
  EXPECT_EQ(one(triangle(0, 9, 9, 0, far, 0, straight(true, -TMax))).t, -far * kStep);
}

TEST(HitUnit, RoundsTiesUp) {
  // u = 1 and 3 halves of the last bit.
  EXPECT_EQ(one(triangle(1, 3, 2 << BaryFrac, 0, 0, 0)).u, 1u);
  EXPECT_EQ(one(triangle(1, 3, 2 << BaryFrac, 0, 0, 0)).v, 2u);
  // u (Az - Cz) is half of the last bit: up to it; minus half: up to 0; and the ray's sign comes after.
  EXPECT_EQ(one(triangle(1, 0, 2 * kStep, 1, 0, 0)).t, 1);
  EXPECT_EQ(one(triangle(1, 0, 2 * kStep, -1, 0, 0)).t, 0);
  EXPECT_EQ(one(triangle(1, 0, 2 * kStep, 1, 0, 0, straight(true, -TMax))).t, -1);
  EXPECT_EQ(one(triangle(1, 0, 2 * kStep, -1, 0, 0, straight(true, -TMax))).t, 0);
  // Two halves are one whole: the sum is rounded, not its parts.
  EXPECT_EQ(one(triangle(1, 1, 2 * kStep, 1, 1, 0)).t, 1);
  // Sphere, norm2 below two: 5 / 2 = 2.5 is 3, doubled: 6 quarter steps. And -5: -6.
  EXPECT_EQ(one(sphere(0, 0, 5 << kGain, straight(false, -TMax))).t, (6 << kGain) * kQuarter);
  EXPECT_EQ(one(sphere(0, 0, -(5 << kGain), straight(false, -TMax))).t, -(6 << kGain) * kQuarter);
  hit_ray_t slanted = straight(false, -TMax);
  slanted.norm2 = 2 << NormFrac;  // 5 / 2 = 2.5 is 3 quarter steps
  EXPECT_EQ(one(sphere(0, 0, 5 << kGain, slanted)).t, (3 << kGain) * kQuarter);
}

TEST(HitUnit, HitsLieStrictlyBeyondTmin) {
  for (bool neg : {false, true}) {
    const std::int64_t z = neg ? -100 : 100;
    EXPECT_TRUE(emitted(triangle(1, 1, 4, z, z, z, straight(neg, 100 * kStep - 1))));
    EXPECT_FALSE(emitted(triangle(1, 1, 4, z, z, z, straight(neg, 100 * kStep))));
    EXPECT_FALSE(emitted(triangle(1, 1, 4, z, z, z, straight(neg, 100 * kStep + 1))));
    EXPECT_FALSE(emitted(triangle(1, 1, 4, -z, -z, -z, straight(neg, 0))));
  }
  EXPECT_FALSE(emitted(triangle(1, 1, 4, 0, 0, 0, straight(false, 0))));
}

TEST(HitUnit, SphereTakesTheNearerRootBeyondTmin) {
  // Centre at 100, radius 30: N R = 15 * 30, disc = 450, root = sqrt(32 * 450) = 120 quarter steps.
  for (bool neg : {false, true}) {
    const std::int64_t cz = neg ? -100 : 100;
    const auto at = [&](t_t tmin, bool cull) {
      hit_ray_t ray = straight(neg, tmin);
      ray.cull = cull;
      return sphere(cz, 450, 0, ray);
    };
    EXPECT_EQ(one(at(0, false)).t, 70 * kStep);
    EXPECT_EQ(one(at(0, true)).t, 70 * kStep);
    EXPECT_EQ(one(at(70 * kStep - 1, false)).t, 70 * kStep);
    EXPECT_EQ(one(at(70 * kStep, false)).t, 130 * kStep);
    EXPECT_FALSE(emitted(at(70 * kStep, true)));
    EXPECT_EQ(one(at(130 * kStep - 1, false)).t, 130 * kStep);
    EXPECT_FALSE(emitted(at(130 * kStep, false)));
    const result_t r = one(at(0, false));
    EXPECT_EQ(r.u + r.v, 0u);
    EXPECT_EQ(r.kind, std::uint64_t{KindSphere});
  }
  // The origin inside: only the farther root is in front.
  EXPECT_EQ(one(sphere(10, 450, 0, straight())).t, 40 * kStep);
  // Behind: none.
  EXPECT_FALSE(emitted(sphere(-40, 450, 0, straight())));
  // towards counts along the ray: centre off the axis.
  EXPECT_EQ(one(sphere(100, 450, 8, straight())).t, 72 * kStep);
  EXPECT_EQ(one(sphere(-100, 450, 8, straight(true))).t, 68 * kStep);
  // Tangent: both roots are the same.
  EXPECT_EQ(one(sphere(100, 0, 0, straight())).t, 100 * kStep);
}

TEST(HitUnit, DistancesSaturate) {
  const std::int64_t far = kGrid - 1;
  const std::uint64_t disc = std::uint64_t{1} << (2 * CoordW - 3);  // of the largest sphere, radius 2^(CoordW-1)
  EXPECT_EQ(one(sphere(far, disc, 0, straight(false, TMax - 1))).t, TMax);
  EXPECT_FALSE(emitted(sphere(far, disc, 0, straight(false, TMax))));
  EXPECT_EQ(one(sphere(-far, disc, 0, straight(false, -TMax - 1))).t, -TMax);
  EXPECT_EQ(one(sphere(far, disc, 0, straight(true, -TMax - 1))).t, -TMax);
  // One last bit too far, either way: 65 steps, 260 quarter steps, beyond the last position.
  EXPECT_EQ(one(sphere(far, 0, 260, straight(false, 0))).t, TMax);
  EXPECT_EQ(one(sphere(-far, 0, -260, straight(false, -TMax - 1))).t, -TMax);
  EXPECT_EQ(one(sphere(far, 0, 256, straight(false, 0))).t, TMax + 1 - kStep);
}

TEST(HitUnit, LargestNumerators) {
  // Around 2^(CoordW+4) quarter steps most bits are lost, just below one less; the result is in range.
  Rng rng(43);
  std::vector<HitCase> cases;
  for (int i = 0; i < 2000; ++i) {
    const bool neg = rng.chance(2);
    const std::int64_t towards = (neg ? -1 : 1) * ((std::int64_t{1} << rng.in(CoordW - 2, CoordW + 4)) + rng.in(-1000, 1000));
    HitCase c = sphere(neg ? kGrid - 1 : 1 - kGrid, static_cast<std::uint64_t>(rng.in(0, 9)), towards, straight(neg, -TMax - 1));
    c.ray.norm2 = static_cast<norm2_t>(rng.chance(2) ? rng.in(1 << NormFrac, (3 << NormFrac) - 1) : 3 * (1 << NormFrac) - rng.in(1, 9));
    cases.push_back(c);
  }
  EXPECT_EQ(run(cases).out.size(), cases.size());
}

TEST(HitUnit, TakesOneEveryCycle) {
  Rng rng(41);
  std::vector<HitCase> triangles, spheres;
  for (int i = 0; i < 1000; ++i) {
    triangles.push_back(any_triangle(rng));
    spheres.push_back(sphere(rng.in(0, 9999), static_cast<std::uint64_t>(rng.in(0, 99999)), rng.in(-9999, 9999), straight()));
  }
  const long alone = 3 + 12 + 7 + 1, root = (CoordW + 2) / 2 + 1;
  EXPECT_EQ(run({triangles[0]}).cycles, alone);
  EXPECT_EQ(run({spheres[0]}).cycles, alone + root);
  EXPECT_EQ(run(triangles).cycles, 999 + alone);
  // As many cycles as there are spheres are lost when the roots of those inside come.
  EXPECT_LE(run(spheres).cycles, 2 * 1000 + 60);
}

TEST(HitUnit, MixesSpheresAndTriangles) {
  Rng rng(42);
  std::vector<HitCase> cases;
  for (int i = 0; i < 400; ++i) {
    for (int k = static_cast<int>(rng.in(0, 3)); k > 0; --k) cases.push_back(any_triangle(rng));
    for (int k = static_cast<int>(rng.in(1, 3)); k > 0; --k)
      cases.push_back(sphere(rng.in(-9999, 9999), static_cast<std::uint64_t>(rng.in(0, 3LL << (2 * CoordW - 3))), rng.in(-99999, 99999), straight(rng.chance(2))));
  }
  run(cases);
}

TEST(HitUnit, ResetEmptiesIt) {
  for (int after : {1, 3, 9, 17, 22, 30}) {
    Dut<Vhit_unit> dut;
    const HitCase cases[2] = {triangle(1, 1, 4, 9, 9, 9), sphere(100, 450, 0, straight())};
    for (int i = 0; i < after; ++i) {
      dut->in_valid_i = 1;
      set_port(dut->in_i, cases[after % 3 == 0].cand);
      set_port(dut->in_ray_i, cases[after % 3 == 0].ray);
      dut.tick();
    }
    dut->in_valid_i = 0;
    dut.reset(1);
    for (int i = 0; i < 60; ++i) {
      dut.settle();
      EXPECT_FALSE(dut->out_valid_o || dut->retire_o) << after;
      EXPECT_TRUE(dut->in_ready_o);
      dut.tick();
    }
  }
}

}  // namespace castray::tb
