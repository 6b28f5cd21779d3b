// SPDX-License-Identifier: Apache-2.0
// Tests of the primitive pipe on spheres; part of ray_prim_test.
#pragma once
#include "ray_prim_run.hpp"

namespace castray::tb {

TEST(RayPrimSphere, TangentHasDiscZero) {
  // Straight ray: N R = R R / 2, X = x / 2: disc is zero at x = R, positive inside.
  const PrimCase tangent = sphere(straight_ray(), {500, 0, 700}, 500);
  EXPECT_EQ(cand_of(tangent).det, 0u);
  EXPECT_FALSE(hits(sphere(straight_ray(), {502, 0, 700}, 500)));
  EXPECT_TRUE(hits(sphere(straight_ray(), {498, 0, 700}, 500)));
  run({tangent, sphere(straight_ray(), {502, 0, 700}, 500), sphere(straight_ray(), {498, 0, 700}, 500)});
}

TEST(RayPrimSphere, InsideBehindAndOfExtremeRadius) {
  const std::int64_t biggest = kHalf - 1;
  std::vector<PrimCase> met, missed;
  for (bool neg : {false, true})
    for (axis_t axis : {0, 1, 2}) {
      const test_ray_t ray = straight_ray(neg, false, axis);
      met.push_back(sphere(ray, {10, -20, 5}, 900));       // the origin is inside
      met.push_back(sphere(ray, {1, 1, -900}, 20));        // behind for a ray along +z: the line meets it
      met.push_back(sphere(ray, {0, 0, 50}, 1));
      met.push_back(sphere(ray, {3000, 3000, 9}, biggest));
      missed.push_back(sphere(ray, {0, 0, 50}, 0));
      missed.push_back(sphere(ray, {0, 0, 50}, biggest + 1));
      missed.push_back(sphere(ray, {biggest, biggest, 50}, biggest));
    }
  EXPECT_EQ(run(met).accepted, int(met.size()));
  EXPECT_EQ(run(missed).accepted, 0);
}

TEST(RayPrimSphere, FarOffTheRayFitsItsMultiplier) {
  // |X Sy - Y Sx| stays below 2^CoordW where all is as large as it gets, rounded as badly as it gets.
  const std::int64_t top = (1 << CoordW) - 1;
  std::int64_t largest = 0;
  std::vector<PrimCase> cases;
  for (int i = 0; i < 1 << 10; ++i) {
    PrimCase s;
    s.prim.number = 1, s.prim.kind = KindSphere;
    s.prim.b.x = kHalf - 1;
    s.ray.axis = 2;
    s.ray.sx = (i & 1 ? -1 : 1) * (kOne - 1 - (i >> 8 & 1));
    s.ray.sy = (i & 2 ? -1 : 1) * (kOne - 1 - (i >> 9 & 1));
    s.ray.norm2 = norm2_of(s.ray.sx, s.ray.sy);
    std::uint64_t* org[3] = {&s.ray.org.x, &s.ray.org.y, &s.ray.org.z};
    std::uint64_t* at[3] = {&s.prim.a.x, &s.prim.a.y, &s.prim.a.z};
    for (int k = 0; k < 3; ++k) {
      const std::int64_t far = top - (i >> (5 + k) & 1);
      *org[k] = static_cast<std::uint64_t>(i >> (2 + k) & 1 ? far : 0);
      *at[k] = static_cast<std::uint64_t>(i >> (2 + k) & 1 ? 0 : far);
    }
    const std::int64_t z = sphere_cross(shear(corner_delta(s.prim.a, s.ray.org, 2), s.ray), s.ray);
    largest = std::max(largest, std::abs(z));
    cases.push_back(s);
  }
  EXPECT_LT(largest, 2 * kHalf);
  EXPECT_GT(largest, 2 * kHalf - 4 - (kHalf >> (ShearFrac - 2)));
  run(cases);
}

TEST(RayPrimSphere, RoundsTiesHalfUp) {
  // |S|^2 R = R for a straight ray, in units of two steps: 3 -> 2 and disc = 2 * 3.
  EXPECT_EQ(cand_of(sphere(straight_ray(), {0, 0, 9}, 3)).det, 6u);
  // Z = X Sy - Y Sx exactly half: X = 1, Sy = +-1/2.
  test_ray_t up = straight_ray(), down = straight_ray();
  up.sy = kOne / 2, down.sy = -kOne / 2;
  up.norm2 = down.norm2 = norm2_of(0, up.sy);
  const PrimCase z_up = sphere(up, {2, 0, 0}, 100), z_down = sphere(down, {2, 0, 0}, 100);
  EXPECT_EQ(cand_of(z_up).det, 63u * 100 - 2 - 2);  // N = 62.5 -> 63, Z = 1
  EXPECT_EQ(cand_of(z_down).det, 63u * 100 - 2);    // Z = 0
  // X Sx exactly half a quarter step: X = 1, Sx = +-1/16.
  test_ray_t right = straight_ray(), left = straight_ray();
  right.sx = kOne / 16, left.sx = -kOne / 16;
  right.norm2 = left.norm2 = norm2_of(right.sx, 0);
  const PrimCase b_up = sphere(right, {2, 0, 0}, 100), b_down = sphere(left, {2, 0, 0}, 100);
  EXPECT_EQ(cand_of(b_up).az, 1);
  EXPECT_EQ(cand_of(b_down).az, 0);
  run({sphere(straight_ray(), {0, 0, 9}, 3), z_up, z_down, b_up, b_down});
}

}  // namespace castray::tb
