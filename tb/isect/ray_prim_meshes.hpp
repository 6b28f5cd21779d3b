// SPDX-License-Identifier: Apache-2.0
// Watertightness of the primitive pipe itself; part of ray_prim_test. A million rays a mesh go
// through the model in watertight_test.
#pragma once
#include "closed_meshes.hpp"
#include "isect/hit_unit.hpp"
#include "ray_prim_run.hpp"

namespace castray::tb {

// Rays from inside closed meshes through their edges and corners: one triangle each in front.
// 20,000 rays a mesh against every triangle whose sheared box the ray meets, edges included; the
// first 1,000 of them against every triangle of the mesh.
class RayPrimMesh : public ::testing::TestWithParam<Mesh (*)()> {};
INSTANTIATE_TEST_SUITE_P(All, RayPrimMesh, ::testing::Values(+[] { return bumpy_sphere(); }, +[] { return lattice_cube(); }));

TEST_P(RayPrimMesh, OneTriangleForEachRay) {
  const Mesh mesh = GetParam()();
  const std::vector<prim_slot_t> slots = mesh.slots();
  std::vector<packed_t<prim_slot_t>> packed;
  for (const prim_slot_t& slot : slots) packed.push_back(pack(slot));
  const int rays = 20000, whole = 1000;
  Rng rng(61);
  Dut<Vray_prim> dut;
  struct Left {
    hit_ray_t ray;
    long tests = 0;
    int front = 0;
  };
  std::deque<Left> left;  // rays whose tests are in the pipe
  long tests = 0, tight = 0, done = 0;
  const auto cycle = [&] {
    dut.settle();
    if (dut->out_valid_o || dut->retire_o) {
      Left& ray = left.front();
      result_t hit;
      ray.front += dut->out_valid_o && hit_unit(get_port<cand_t>(dut->out_o), ray.ray, hit);
      if (--ray.tests == 0) {
        tight += ray.front == 1;
        ++done;
        left.pop_front();
      }
    }
    dut.tick();
  };
  for (int i = 0; i < rays; ++i) {
    const AimedRay aimed = aim(mesh, rng);
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const auto at = [&](const point_t& p) { return shear(corner_delta(p, aimed.ray.org, aimed.ray.axis), aimed.ray); };
      const sheared2_t a = at(slots[k].a), b = at(slots[k].b), c = at(slots[k].c);
      const bool meets = std::min({a.x, b.x, c.x}) <= 0 && std::max({a.x, b.x, c.x}) >= 0 && std::min({a.y, b.y, c.y}) <= 0 &&
                         std::max({a.y, b.y, c.y}) >= 0;
      if (i < whole || meets) near.push_back(k);
    }
    Left ray;
    ray.ray.norm2 = aimed.ray.norm2, ray.ray.neg = aimed.ray.neg;
    ray.tests = static_cast<long>(near.size());
    ASSERT_GT(ray.tests, 0);
    left.push_back(ray);
    tests += ray.tests;
    dut->in_valid_i = 1;
    set_port(dut->in_ctx_i, i % 64);
    set_port(dut->in_ray_i, aimed.ray);
    for (std::size_t k : near) {
      for (std::size_t w = 0; w < packed[k].size(); ++w) dut->in_prim_i[w] = packed[k][w];
      cycle();
    }
  }
  dut->in_valid_i = 0;
  for (int i = 0; i < kLatency; ++i) cycle();
  std::printf("%s: %ld tests, %d rays, exactly one triangle for %ld\n", mesh.name.c_str(), tests, rays, tight);
  EXPECT_EQ(done, rays);
  EXPECT_EQ(tight, rays);
}

}  // namespace castray::tb
