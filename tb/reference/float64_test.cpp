// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The float64 reference: the four views of the teapot, and its definitions one by one.
#include "reference/float64.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../scene/flat_triangle.hpp"
#include "scene/camera.hpp"
#include "scene/load.hpp"

namespace castray {
namespace {

// ---- The four views: geometry, camera and tracer together ----

void expect_hits(const char* view, std::size_t hits) {
  const Scene scene = load_scene(std::string("scenes/") + view + ".json");
  EXPECT_EQ(trace_float64(scene, 320, 240).hits, hits);
  EXPECT_TRUE(scene.defaults.empty() && scene.warnings.empty());
}
TEST(Float64, TeapotBase) { expect_hits("teapot", 26428); }
TEST(Float64, TeapotTight) { expect_hits("teapot_tight", 59248); }
TEST(Float64, TeapotFit) { expect_hits("teapot_fit", 14008); }
TEST(Float64, TeapotInterior) { expect_hits("teapot_interior", 76800); }

// ---- One pixel at a time: a frame of 1 x 1 looks along -z ----

struct OnePixel : testing::Test {
  OnePixel() {
    scene.paint.background = {7, 8, 9};
    scene.paint.colour_a = {200, 100, 50};
    scene.paint.colour_b = {20, 40, 60};
  }
  ReferencePixel pixel() const { return trace_float64(scene, 1, 1, 0, 0); }
  // In the plane at z, around the axis.
  void add(double z) { scene.triangles.push_back(tb::flat_triangle({-1, -1, z}, {2, -1, z}, {-1, 2, z})); }
  Scene scene;
};

TEST_F(OnePixel, Miss) {
  add(1);  // behind the eye
  const ReferencePixel miss = pixel();
  EXPECT_EQ(miss.prim, -1);
  EXPECT_TRUE(std::isinf(miss.t));
  EXPECT_EQ(miss.colour, (Rgb{7, 8, 9}));
}

TEST_F(OnePixel, DistanceAndWeights) {
  scene.triangles.push_back(tb::flat_triangle({-1, -1, -4}, {3, -1, -4}, {-1, 3, -4}));
  const ReferencePixel hit = pixel();
  EXPECT_EQ(hit.prim, 0);
  EXPECT_DOUBLE_EQ(hit.t, 4);
  EXPECT_DOUBLE_EQ(hit.u, 0.5);   // of corner 0
  EXPECT_DOUBLE_EQ(hit.v, 0.25);  // of corner 1
  EXPECT_EQ(hit.colour, (Rgb{200, 100, 50}));
}

TEST_F(OnePixel, BothSidesAreHit) {
  scene.triangles.push_back(tb::flat_triangle({-1, -1, -4}, {-1, 3, -4}, {3, -1, -4}));
  EXPECT_EQ(pixel().prim, 0);
  EXPECT_EQ(pixel().colour, (Rgb{200, 100, 50}));
}

TEST_F(OnePixel, NearestWins) {
  add(-5);
  add(-3);
  add(-4);
  EXPECT_EQ(pixel().prim, 1);
}

TEST_F(OnePixel, EqualDistancesGoToTheLowerNumber) {
  add(-5);
  add(-3);
  add(-3);
  scene.spheres.push_back({.centre = {0, 0, -4}, .radius = 1});
  EXPECT_EQ(pixel().prim, 1);
  for (int i = 0; i < 100; ++i) add(-3);  // across blocks of the tracer
  EXPECT_EQ(pixel().prim, 1);
}

TEST_F(OnePixel, SphereFromOutsideAndInside) {
  scene.spheres.push_back({.centre = {0, 0, -5}, .radius = 2});
  EXPECT_DOUBLE_EQ(pixel().t, 3);
  scene.spheres[0].centre.z = -1;
  EXPECT_DOUBLE_EQ(pixel().t, 3);
  EXPECT_EQ(pixel().u, 0);
  scene.spheres[0].centre.z = 3;
  EXPECT_EQ(pixel().prim, -1);
  scene.spheres[0].centre = {2.001, 0, -5};
  EXPECT_EQ(pixel().prim, -1);
}

TEST_F(OnePixel, FacingRatioIsRoundedToNearest) {
  add(-4);
  for (Vec3& normal : scene.triangles[0].normal) normal = Vec3(0.6, 0, -0.8);
  EXPECT_EQ(pixel().colour, (Rgb{160, 80, 40}));
  for (Vec3& normal : scene.triangles[0].normal) normal = Vec3(std::sqrt(1 - 0.4525 * 0.4525), 0, 0.4525);
  EXPECT_EQ(pixel().colour, (Rgb{91, 45, 23}));  // 90.5, 45.25, 22.625
}

TEST_F(OnePixel, InterpolatedNormalIsNormalised) {
  scene.triangles.push_back(tb::flat_triangle({-1, -1, -4}, {3, -1, -4}, {-1, 3, -4}));  // weights 1/2, 1/4, 1/4
  scene.triangles[0].normal = {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 0, 0)};
  EXPECT_EQ(pixel().colour[0], std::floor(200 * std::sqrt(0.5) + 0.5));
}

TEST_F(OnePixel, NormalsThatCancelGiveWayToTheFace) {
  scene.triangles.push_back(tb::flat_triangle({-1, -1, -4}, {3, -1, -4}, {-1, 3, -4}));
  scene.triangles[0].normal = {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(-1, 0, 0)};
  EXPECT_EQ(pixel().colour, (Rgb{200, 100, 50}));
}

TEST_F(OnePixel, CheckerCells) {
  add(-4);
  const auto odd_at = [&](double s, double t) {
    for (Vec2& tex : scene.triangles[0].tex) tex = {s, t};
    EXPECT_EQ(pixel().colour, pixel().odd ? scene.paint.colour_b : scene.paint.colour_a);
    return pixel().odd;
  };
  scene.paint.checker_scale = 4;
  EXPECT_FALSE(odd_at(0.1, 0.1));
  EXPECT_TRUE(odd_at(0.3, 0.1));
  EXPECT_TRUE(odd_at(0.1, 0.3));
  EXPECT_FALSE(odd_at(0.3, 0.3));
  EXPECT_TRUE(odd_at(-0.1, 0.1));  // cells are floors: -1
  EXPECT_FALSE(odd_at(-0.1, -0.1));
}

TEST_F(OnePixel, MaterialsForceAColour) {
  add(-4);
  scene.triangles[0].material = Material::ColourB;
  EXPECT_EQ(pixel().colour, scene.paint.colour_b);
  for (Vec2& tex : scene.triangles[0].tex) tex = {0.3, 0.1};
  scene.triangles[0].material = Material::ColourA;
  EXPECT_EQ(pixel().colour, scene.paint.colour_a);
  EXPECT_TRUE(pixel().odd);
}

// (s, t) of a sphere is its normal's (x, y), from -1..1 to 0..1; seen head on that is (1/2, 1/2).
TEST_F(OnePixel, SphereTexture) {
  scene.spheres.push_back({.centre = {0, 0, -5}, .radius = 2});
  scene.paint.checker_scale = 3;
  EXPECT_FALSE(pixel().odd);  // cell (1, 1)
  scene.spheres[0].centre.x = -0.8;  // x of the normal 0.4, s = 0.7: cell (2, 1)
  EXPECT_TRUE(pixel().odd);
  EXPECT_EQ(pixel().colour[0], std::floor(20 * std::sqrt(1 - 0.16) + 0.5));
}

// ---- Rays ----

TEST(Rays, GoThroughPixelCentres) {
  Scene scene;
  scene.camera.field_of_view = 90;
  scene.triangles.push_back(tb::flat_triangle({-1000, -1000, -1}, {1000, -1000, -1}, {0, 2000, -1}));
  // At distance 1 the picture is 2 high and 4 wide: pixels of 1/2.
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) {
      const ReferencePixel hit = trace_float64(scene, 8, 4, x, y);
      EXPECT_NEAR(hit.t, Vec3(-1.75 + 0.5 * x, 0.75 - 0.5 * y, -1).length(), 1e-12);
    }
}

TEST(Rays, FollowTheCamerasMatrix) {
  Scene scene;
  scene.triangles.push_back(tb::flat_triangle({5, -1, -1}, {5, 2, -1}, {5, -1, 2}));
  look_at({1, 0, 0}, {9, 0, 0}, {0, 1, 0}, scene.camera.to_world);
  EXPECT_DOUBLE_EQ(trace_float64(scene, 1, 1, 0, 0).t, 4);
  scene.camera.to_world[2][0] *= 10;  // a longer axis back: the same direction
  EXPECT_DOUBLE_EQ(trace_float64(scene, 1, 1, 0, 0).t, 4);
}

TEST(Frame, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = load_scene("scenes/spheres.json");
  int rows = 0;
  const ReferenceFrame one = trace_float64(scene, 64, 48, 1, [&](int finished) { EXPECT_EQ(finished, ++rows); });
  const ReferenceFrame four = trace_float64(scene, 64, 48, 4);
  EXPECT_EQ(rows, 48);
  EXPECT_EQ(one.hits, four.hits);
  for (std::size_t i = 0; i < one.pixels.size(); ++i) {
    EXPECT_EQ(one.pixels[i].prim, four.pixels[i].prim);
    EXPECT_EQ(one.pixels[i].colour, four.pixels[i].colour);
  }
  const ReferencePixel single = trace_float64(scene, 64, 48, 33, 20);
  EXPECT_EQ(single.t, one.at(33, 20).t);
}

}  // namespace
}  // namespace castray
