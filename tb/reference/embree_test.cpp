// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Embree sees what the float64 reference sees, but for pixels whose line passes an edge within float32's
// rounding; one ray at a time and in packets.
#include "reference/embree.hpp"

#include <gtest/gtest.h>

#include "../frame/random_scene.hpp"
#include "reference/disagreement.hpp"
#include "reference/float64.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

std::vector<int> prims_of(const ReferenceFrame& frame) {
  std::vector<int> prims;
  for (const ReferencePixel& pixel : frame.pixels) prims.push_back(pixel.prim);
  return prims;
}

void check(const Scene& scene, int width, int height, std::size_t most) {
  const Embree embree(scene);
  const std::vector<int> expected = prims_of(trace_float64(scene, width, height));
  for (const int packet : {1, 4, 8, 16}) {
    const EmbreeFrame frame = embree.frame(width, height, packet);
    ASSERT_EQ(frame.prims.size(), expected.size());
    EXPECT_GT(frame.seconds, 0);
    const auto found = disagreements(scene, width, height, expected, frame.prims);
    EXPECT_LE(found.size(), most) << "packets of " << packet;
    for (const Disagreement& d : found)
      EXPECT_NE(d.cause, Cause::Unexplained) << "(" << d.x << ", " << d.y << "): " << d.ours << " and " << d.theirs;
  }
}

TEST(Embree, SeesWhatFloat64Sees) {
  for (const char* name : {"teapot", "teapot_tight", "teapot_interior", "teapot_flipped", "spheres", "cube"}) {
    SCOPED_TRACE(name);
    check(load_scene(std::string("scenes/") + name + ".json"), 80, 60, 1);
  }
}

// Sizes that no block of pixels divides; eyes inside spheres, slivers, shared edges.
TEST(Embree, OfRandomScenes) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const RandomScene random = random_scene(seed);
    SCOPED_TRACE(random.text);
    if (random.ties) continue;
    check(random.scene, 33, 17, 1);
  }
}

// Two triangles in one place: each tracer takes one of them, and it is a tie where they differ.
TEST(Embree, OfTies) {
  for (unsigned seed = 0; seed < 100; seed += 5) {
    const RandomScene random = random_scene(seed);
    SCOPED_TRACE(random.text);
    check(random.scene, 33, 17, 33 * 17);
  }
}

TEST(Embree, OfAnEyeInsideASphereIsTheFarSide) {
  Scene scene;
  scene.spheres.push_back({.centre = {0, 0, 0}, .radius = 2});
  EXPECT_EQ(Embree(scene).frame(3, 3, 1).prims, std::vector<int>(9, 0));
  EXPECT_EQ(Embree(scene).frame(3, 3, 16).prims, std::vector<int>(9, 0));
}

TEST(Embree, SpheresAreNumberedBehindTriangles) {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.triangles.push_back({.corner = {Vec3(10, 0, 0), Vec3(11, 0, 0), Vec3(10, 1, 0)}});
  scene.spheres.push_back({.centre = {0, 0, 9}, .radius = 1});
  scene.spheres.push_back({.centre = {0, 0, -9}, .radius = 1});
  EXPECT_EQ(Embree(scene).frame(1, 1, 1).prims.at(0), 4);
}

TEST(Embree, KnowsNoOtherPackets) {
  Scene scene;
  scene.spheres.push_back({});
  EXPECT_THROW(Embree(scene).frame(1, 1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace castray::tb
