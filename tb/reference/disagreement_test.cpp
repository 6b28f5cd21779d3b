// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The cause of a disagreement: an edge, a tie, or none that rounding can explain.
#include "reference/disagreement.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace castray {
namespace {

// The camera looks along -z from the origin; the line of the only pixel is the axis.
Scene scene_of(std::vector<Triangle> triangles) {
  Scene scene;
  scene.triangles = std::move(triangles);
  return scene;
}
// At distance 8, its left side at x.
Triangle right_of(double x, double z = -8) { return {.corner = {Vec3(x, -2, z), Vec3(x + 4, 0, z), Vec3(x, 2, z)}}; }

Disagreement cause(const Scene& scene, int ours, int theirs) { return explain(scene, 1, 1, 0, 0, ours, theirs); }

TEST(Disagreement, AtASideIsAnEdge) {
  const Scene scene = scene_of({right_of(1e-6)});
  const Disagreement found = cause(scene, 0, -1);
  EXPECT_EQ(found.cause, Cause::Edge);
  EXPECT_NEAR(found.distance, 1e-6, 1e-12);
  EXPECT_NEAR(found.rounding, 8 * 0x1p-24 * std::hypot(8, 4), 1e-6);
  EXPECT_EQ(found.float64, -1);
  EXPECT_EQ(cause(scene, -1, 0).cause, Cause::Edge);
}

TEST(Disagreement, BesideASideIsNone) {
  EXPECT_EQ(cause(scene_of({right_of(1e-5)}), 0, -1).cause, Cause::Unexplained);
  EXPECT_EQ(cause(scene_of({right_of(-1e-5)}), -1, 0).cause, Cause::Unexplained);
}

TEST(Disagreement, AtACornerIsAnEdge) {
  const Triangle corner{.corner = {Vec3(1e-6, 1e-6, -8), Vec3(4, 1, -8), Vec3(1, 4, -8)}};
  EXPECT_EQ(cause(scene_of({corner}), 0, -1).cause, Cause::Edge);
  const Triangle beyond{.corner = {Vec3(-1, 1e-6, -8), Vec3(-4, 1e-6, -8), Vec3(-1, 4, -8)}};  // its side's extension is near
  EXPECT_EQ(cause(scene_of({beyond}), 0, -1).cause, Cause::Unexplained);
}

// What matters is the edge of the nearer one: the farther is seen where that is missed.
TEST(Disagreement, OfANearAndAFarOneIsTheNearersEdge) {
  EXPECT_EQ(cause(scene_of({right_of(1e-7, -5), right_of(-1, -8)}), 0, 1).cause, Cause::Edge);
  EXPECT_EQ(cause(scene_of({right_of(-1, -5), right_of(1e-7, -8)}), 0, 1).cause, Cause::Unexplained);
  EXPECT_EQ(cause(scene_of({right_of(-1, -5), right_of(1e-7, -8)}), 1, 0).cause, Cause::Unexplained);
}

TEST(Disagreement, AtOneDistanceIsATie) {
  const Disagreement found = cause(scene_of({right_of(-1), right_of(-1.5, -8.000001)}), 0, 1);
  EXPECT_EQ(found.cause, Cause::Tie);
  EXPECT_NEAR(found.distance, 1e-6, 1e-9);
  EXPECT_EQ(cause(scene_of({right_of(-1), right_of(-1.5, -8.0001)}), 0, 1).cause, Cause::Unexplained);
}

// Seen edge-on, a triangle's plane says nothing of where it is.
TEST(Disagreement, OfATriangleSeenEdgeOn) {
  const Triangle edge_on{.corner = {Vec3(1e-7, -1, -4), Vec3(1e-7, 1, -4), Vec3(2e-7, 0, -6)}};
  EXPECT_EQ(cause(scene_of({edge_on, right_of(-1)}), 0, 1).cause, Cause::Edge);
}

TEST(Disagreement, AtASpheresOutline) {
  Scene scene;
  scene.spheres.push_back({.centre = {1.000001, 0, -8}, .radius = 1});
  EXPECT_EQ(cause(scene, 0, -1).cause, Cause::Edge);
  scene.spheres[0].radius = 1.001;
  EXPECT_EQ(cause(scene, -1, 0).cause, Cause::Unexplained);
}

TEST(Disagreement, ListsThePixelsThatDiffer) {
  const Scene scene = scene_of({right_of(-1)});
  const std::vector<int> ours = {0, 0, -1, 0}, theirs = {0, -1, -1, 0};
  const auto found = disagreements(scene, 2, 2, ours, theirs);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].x, 1);
  EXPECT_EQ(found[0].y, 0);
  EXPECT_EQ(found[0].ours, 0);
  EXPECT_EQ(found[0].theirs, -1);
}

}  // namespace
}  // namespace castray
