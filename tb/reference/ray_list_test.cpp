// SPDX-License-Identifier: Apache-2.0
// The references' answers to a list of rays: equal to the frame's where the rays are a camera's, and
// ranges, culling, ignored primitives and any hit one by one.
#include "reference/ray_list.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/float64.hpp"
#include "reference/pixel_ray.hpp"
#include "scene/load.hpp"

namespace castray {
namespace {

std::vector<ListRay> camera_rays(const Scene& scene, int width, int height) {
  std::vector<ListRay> rays;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) rays.push_back({.origin = scene.camera.eye(), .direction = pixel_direction(scene, width, height, x, y)});
  return rays;
}

TEST(RayListReference, CameraRaysGiveTheFramesHits) {
  for (const char* file : {"scenes/teapot.json", "scenes/spheres.json", "scenes/teapot_interior.json"}) {
    const Scene scene = load_scene(file);
    const ReferenceFrame frame = trace_float64(scene, 48, 36);
    const std::vector<ReferenceHit> hits = trace_list_float64(scene, camera_rays(scene, 48, 36));
    ASSERT_EQ(hits.size(), frame.pixels.size());
    std::size_t met = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      ASSERT_EQ(hits[i].prim, frame.pixels[i].prim) << file << " " << i;
      if (hits[i].prim < 0) continue;
      ++met;
      EXPECT_NEAR(hits[i].distance, frame.pixels[i].t, 1e-12 * frame.pixels[i].t);
      EXPECT_NEAR(hits[i].u, frame.pixels[i].u, 1e-9);
      EXPECT_NEAR(hits[i].v, frame.pixels[i].v, 1e-9);
    }
    EXPECT_EQ(met, frame.hits);
    EXPECT_GT(met, 100u);
  }
}

TEST(RayListReference, Float32SeesTheSameButForRounding) {
  const Scene scene = load_scene("scenes/teapot.json");
  const std::vector<ListRay> rays = camera_rays(scene, 64, 48);
  const auto exact = trace_list_float64(scene, rays), rounded = trace_list_float32(scene, rays);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    differ += exact[i].prim != rounded[i].prim;
    if (exact[i].prim >= 0 && exact[i].prim == rounded[i].prim) EXPECT_NEAR(rounded[i].distance, exact[i].distance, 1e-4 * exact[i].distance);
  }
  EXPECT_LT(differ, rays.size() / 200);
}

// Triangles across z at 1, 2 and 3, the middle one seen from behind along +z; a sphere from 6 to 8.
struct Row : testing::Test {
  Row() {
    for (const double z : {1.0, 2.0, 3.0}) {
      Triangle triangle;
      triangle.corner = {Vec3(-1, -1, z), Vec3(-1, 3, z), Vec3(3, -1, z)};
      if (z == 2) std::swap(triangle.corner[1], triangle.corner[2]);
      scene.triangles.push_back(triangle);
    }
    scene.spheres.push_back({.centre = Vec3(0, 0, 7), .radius = 1});
  }
  ReferenceHit hit(ListRay ray) const {
    if (ray.direction == Vec3(0)) ray.direction = Vec3(0, 0, 1);
    const ReferenceHit one = trace_list_float64(scene, std::span(&ray, 1), 1).at(0);
    EXPECT_EQ(trace_list_float32(scene, std::span(&ray, 1), 1).at(0).prim, one.prim);
    return one;
  }
  int prim(const ListRay& ray) const { return hit(ray).prim; }
  Scene scene;
};

TEST_F(Row, NearestDistanceAndWeights) {
  const ReferenceHit first = hit({.direction = Vec3(0, 0, 10)});
  EXPECT_EQ(first.prim, 0);
  EXPECT_EQ(first.distance, 1) << "in scene units, however long the direction";
  EXPECT_DOUBLE_EQ(first.u, 0.5);
  EXPECT_DOUBLE_EQ(first.v, 0.25);
  EXPECT_EQ(hit({.direction = Vec3(0, 0, 1e-300)}).distance, 1);
  EXPECT_EQ(prim({.direction = Vec3(0, 0, -1)}), -1);
  EXPECT_TRUE(std::isinf(hit({.direction = Vec3(0, 0, -1)}).distance));
}

TEST_F(Row, HitsLieStrictlyBetweenTminAndTmax) {
  EXPECT_EQ(prim({.tmin = 0.5}), 0);
  EXPECT_EQ(prim({.tmin = 1}), 1);
  EXPECT_EQ(prim({.tmin = 2.5}), 2);
  EXPECT_EQ(prim({.tmin = 3}), 3);
  EXPECT_EQ(hit({.tmin = 6}).distance, 8) << "the far side of the sphere";
  EXPECT_EQ(prim({.tmin = 8}), -1);
  EXPECT_EQ(prim({.tmax = 1}), -1);
  EXPECT_EQ(prim({.tmax = 1.5}), 0);
  EXPECT_EQ(prim({.tmin = 1.5, .tmax = 2}), -1);
  EXPECT_EQ(prim({.tmin = -5}), 0);
  EXPECT_EQ(prim({.origin = Vec3(0, 0, 1.5), .tmin = -5}), 1) << "a negative tmin counts as 0";
}

TEST_F(Row, CullingLeavesOutWhatIsSeenFromBehind) {
  const auto& [a, b, c] = scene.triangles[0].corner;
  ASSERT_LT((b - a).cross(c - a).z, 0) << "counter-clockwise as a ray along +z sees it";
  EXPECT_EQ(prim({.cull = true}), 0);
  EXPECT_EQ(prim({.tmin = 1, .cull = true}), 2);
  EXPECT_EQ(prim({.origin = Vec3(0, 0, 5), .direction = Vec3(0, 0, -1), .cull = true}), 1);
  EXPECT_EQ(prim({.origin = Vec3(0, 0, 7)}), 3) << "from inside";
  EXPECT_EQ(prim({.origin = Vec3(0, 0, 7), .cull = true}), -1) << "a sphere's inside is its back";
}

TEST_F(Row, IgnoredPrimitives) {
  EXPECT_EQ(prim({.ignore = 0}), 1);
  EXPECT_EQ(prim({.ignore = 1}), 0);
  EXPECT_EQ(prim({.tmin = 4, .ignore = 3}), -1);
}

TEST_F(Row, AnyHitIsThereWhereTheNearestIs) {
  EXPECT_GE(prim({.any = true}), 0);
  EXPECT_EQ(prim({.tmin = 4, .any = true}), 3);
  EXPECT_EQ(prim({.tmin = 4, .tmax = 5, .any = true}), -1);
  EXPECT_EQ(prim({.tmin = 4, .any = true, .ignore = 3}), -1);
}

TEST_F(Row, EqualDistancesGoToTheLowerNumber) {
  scene.triangles[1] = scene.triangles[0];
  EXPECT_EQ(prim({}), 0);
  EXPECT_EQ(prim({.ignore = 0}), 1);
}

TEST(RayListReference, ThreadsAndProgress) {
  const Scene scene = load_scene("scenes/spheres.json");
  const std::vector<ListRay> rays = camera_rays(scene, 40, 30);
  double last = 0;
  const auto many = trace_list_float64(scene, rays, 3, [&](double share) {
    EXPECT_GT(share, last);
    last = share;
  });
  EXPECT_EQ(last, 1);
  const auto one = trace_list_float64(scene, rays, 1);
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_TRUE(one[i].prim == many[i].prim && (one[i].distance == many[i].distance)) << i;
  EXPECT_TRUE(trace_list_float64(scene, {}).empty());
}

}  // namespace
}  // namespace castray
