// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The tessellated teapot: counts, box, closed seams, normals, and that scenes/teapot.geo is it.
#include "scene/teapot.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scene/camera.hpp"
#include "scene/files.hpp"
#include "scene/geo.hpp"

namespace castray {
namespace {

std::size_t triangles(const Mesh& mesh) {
  std::size_t count = 0;
  for (const std::uint32_t size : mesh.face_sizes) count += size - 2;
  return count;
}

Scene scene_of(const Mesh& mesh) {
  Scene scene;
  add_mesh(scene, mesh, Matrix(), Material::Checker, "teapot");
  return scene;
}

TEST(Teapot, TenByTenHasTheReportsTriangles) {
  const Mesh mesh = teapot_mesh(10);
  EXPECT_EQ(mesh.points.size(), 3241u);
  EXPECT_EQ(mesh.face_sizes.size(), 3200u);
  EXPECT_EQ(triangles(mesh), 6320u);
  const Scene scene = scene_of(mesh);
  EXPECT_EQ(scene.triangles.size(), 6320u);
  EXPECT_EQ(scene.dropped_triangles, 0u);
}

TEST(Teapot, FinerOnes) {
  EXPECT_EQ(scene_of(teapot_mesh(40)).triangles.size(), 102080u);
  EXPECT_EQ(scene_of(teapot_mesh(125)).triangles.size(), 999000u);
}

TEST(Teapot, Box) {
  Vec3 low, high;
  bounds(scene_of(teapot_mesh(10)), low, high);
  EXPECT_EQ(low, Vec3(-3, 0, -2));
  EXPECT_NEAR(high.x, 3.434, 5e-5);
  EXPECT_EQ(high.y, 3.15);
  EXPECT_EQ(high.z, 2);
}

// Every border of a triangle is that of exactly one other, run the other way, except the open rims:
// body, lid (40 each), and both ends of handle and spout (20 each).
TEST(Teapot, SeamsAreClosed) {
  const Mesh mesh = teapot_mesh(10);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    for (std::uint32_t k = 0; k < size; ++k) ++sides[{mesh.corners[first + k], mesh.corners[first + (k + 1) % size]}];
    first += size;
  }
  int open = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1) << side.first << " to " << side.second;
    open += sides.count({side.second, side.first}) == 0;
  }
  EXPECT_EQ(open, 40 + 40 + 2 * 20 + 2 * 20);
}

TEST(Teapot, NormalsPointOutwardWithTheFaces) {
  const Scene scene = scene_of(teapot_mesh(10));
  for (const Triangle& triangle : scene.triangles)
    for (const Vec3& normal : triangle.normal) {
      EXPECT_NEAR(normal.length(), 1, 1e-12);
      EXPECT_GT(normal.dot(triangle.face), 0.3);
    }
  for (std::size_t i = 800; i < 2400; ++i) {  // the body faces away from its axis
    const Vec3& at = scene.triangles[i].corner[0];
    EXPECT_GT(scene.triangles[i].face.dot(Vec3(at.x, 0, at.z)), 0);
  }
  EXPECT_GT(scene.triangles[2400].face.y, 0);  // the top of the lid
  for (std::size_t i = 3960; i < 4720; ++i) EXPECT_LT(scene.triangles[i].face.y, 0);  // the base
}

TEST(Teapot, CommittedFileIsThisMesh) { EXPECT_TRUE(read_file("scenes/teapot.geo") == geo_text(teapot_mesh(10))); }

}  // namespace
}  // namespace castray
