// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Rays from inside closed meshes through their edges and corners: each is accepted, in front of the
// origin, by exactly one triangle. A million rays a mesh, every ray against every triangle.
#include <gtest/gtest.h>

#include <thread>

#include "closed_meshes.hpp"
#include "isect/hit_unit.hpp"

namespace castray::tb {
namespace {

struct Tally {
  long rays = 0, missed = 0, doubled = 0, wrong_behind = 0;
  long corners = 0, on_edge = 0, on_corner = 0;  // aimed at; accepted with one, two of U, V, W zero
};

Tally shoot(const Mesh& mesh, long rays, unsigned seed) {
  Tally tally;
  Rng rng(seed);
  const std::vector<prim_slot_t> slots = mesh.slots();
  for (; tally.rays < rays; ++tally.rays) {
    const AimedRay aimed = aim(mesh, rng);
    tally.corners += aimed.corner;
    int front = 0, behind = 0;
    for (const prim_slot_t& slot : slots) {
      cand_t cand;
      if (!ray_prim(aimed.ray, slot, 0, cand)) continue;
      hit_ray_t ray;
      ray.norm2 = aimed.ray.norm2, ray.neg = aimed.ray.neg;
      result_t hit;
      if (!hit_unit(cand, ray, hit)) {
        ++behind;
        continue;
      }
      ++front;
      const int zeros = (cand.u == 0) + (cand.v == 0) + (cand.u + cand.v == cand.det);
      tally.on_edge += zeros == 1;
      tally.on_corner += zeros == 2;
    }
    tally.missed += front == 0;
    tally.doubled += front > 1;
    tally.wrong_behind += behind != 1;  // the line leaves the mesh behind the origin just so
  }
  return tally;
}

void expect_tight(const Mesh& mesh) {
  ASSERT_GE(mesh.faces.size(), 1000u);
  ASSERT_LE(mesh.faces.size(), 2000u);
  ASSERT_TRUE(closed(mesh));
  for (int i = 0; i < 8; ++i) {
    Grid3 org;
    for (int k = 0; k < 3; ++k) org[k] = kMiddle + (i >> k & 1 ? 1 : -1) * (mesh.inside - 1);
    ASSERT_TRUE(star_shaped_from(mesh, org));  // from a box's corners, so from all of it
  }
  Tally half[2];
  std::thread other([&] { half[1] = shoot(mesh, 500000, 2); });
  half[0] = shoot(mesh, 500000, 1);
  other.join();
  const auto sum = [&](long Tally::*field) { return half[0].*field + half[1].*field; };
  std::printf("%s, %zu triangles: %ld rays (%ld at corners), %ld missed, %ld doubled; accepted exactly on an edge %ld, on a corner %ld\n",
              mesh.name.c_str(), mesh.faces.size(), sum(&Tally::rays), sum(&Tally::corners), sum(&Tally::missed),
              sum(&Tally::doubled), sum(&Tally::on_edge), sum(&Tally::on_corner));
  EXPECT_EQ(sum(&Tally::rays), 1000000);
  EXPECT_EQ(sum(&Tally::missed), 0);
  EXPECT_EQ(sum(&Tally::doubled), 0);
  EXPECT_EQ(sum(&Tally::wrong_behind), 0);
  EXPECT_GT(sum(&Tally::on_edge), 10000);
  EXPECT_GT(sum(&Tally::on_corner), 1000);
}

}  // namespace

TEST(Watertight, BumpySphere) { expect_tight(bumpy_sphere()); }
TEST(Watertight, LatticeCube) { expect_tight(lattice_cube()); }

}  // namespace castray::tb
