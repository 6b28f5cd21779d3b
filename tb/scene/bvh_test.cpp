// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The hierarchy of whole images: every primitive once, inside every box above it; at most 32 levels;
// the same bytes from the same scene.
#include "scene/bvh.hpp"

#include <sched.h>

#include <random>
#include <thread>

#include "../frame/random_scene.hpp"
#include "scene/load.hpp"
#include "scene/teapot.hpp"
#include "tree_check.hpp"

namespace castray::tb {
namespace {

Triangle triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  Triangle made;
  made.corner = {a, b, c};
  return made;
}

Scene scene_of(std::vector<Triangle> triangles) {
  Scene scene;
  scene.file = "s";
  scene.triangles = std::move(triangles);
  return scene;
}

SceneImage checked(const Scene& scene) {
  SceneImage image = compile(scene, 1, 1);
  check_tree(image);
  return image;
}

TEST(Bvh, OfTheScenes) {
  for (const char* name : {"teapot", "teapot_tight", "teapot_interior", "spheres", "cube", "tiny"})
    checked(load_scene(std::string("scenes/") + name + ".json"));
}

TEST(Bvh, OfRandomScenes) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    checked(random_scene(seed).scene);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST(Bvh, OfAFinerTeapot) {
  Scene scene;
  scene.file = "s";
  add_mesh(scene, teapot_mesh(40), Matrix(), Material::Checker, "s");
  EXPECT_EQ(checked(scene).header.primitives, 102080u);
}

TEST(Bvh, OfOneTriangleIsANodeWithALeaf) {
  const SceneImage image = checked(scene_of({triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}));
  EXPECT_EQ(image.header.nodes.count, 1u);
  EXPECT_EQ(image.header.lines.count, 1u);
}

TEST(Bvh, OfTwoTrianglesThatShareTheirBoxIsOneLeaf) {
  const Triangle one = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const SceneImage image = checked(scene_of({one, one}));
  EXPECT_EQ(image.header.nodes.count, 1u);
  EXPECT_EQ(image.header.lines.count, 1u);
  EXPECT_EQ(load_slot(image.bytes.data(), image.header, 0).number, 0u);
  EXPECT_EQ(load_slot(image.bytes.data(), image.header, 1).number, 1u);
}

TEST(Bvh, OfOneSphere) {
  Scene scene = scene_of({});
  scene.spheres.push_back({.centre = {1, 2, 3}, .radius = 2});
  checked(scene);
}

TEST(Bvh, DroppedPrimitivesAreInNoLeaf) {
  const Triangle flat = triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), one = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const SceneImage image = checked(scene_of({flat, one, flat}));
  EXPECT_EQ(image.dropped_triangles, 2u);
  EXPECT_EQ(load_slot(image.bytes.data(), image.header, 0).number, 1u);
}

// ---- Scenes that make the heuristic's trees deep ----

TEST(Bvh, OfManyEqualTriangles) {
  const SceneImage image = checked(scene_of(std::vector<Triangle>(5000, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}))));
  EXPECT_LE(image.header.lines.count, 4000u);
}

// Each larger than all before it together, one corner common: a split parts the largest from the rest.
TEST(Bvh, OfTrianglesThatGrowAndNest) {
  std::vector<Triangle> nested;
  for (int i = 0; i < 2000; ++i) {
    const double size = std::exp2(24.0 * i / 2000 - 24);
    nested.push_back(triangle({0, 0, 0}, {size, 0, 0}, {0, size, size}));
  }
  checked(scene_of(nested));
}

TEST(Bvh, OfPointsThatCrowdIntoThreeCorners) {
  std::vector<Triangle> crowded;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 400; ++i) {
      Vec3 at(0);
      at[axis] = 1 - std::exp2(-24.0 * i / 400);
      at[(axis + 1) % 3] = std::exp2(-24.0 * i / 400) / 3;
      const double size = std::exp2(-24.0 * i / 400 - 4);
      crowded.push_back(triangle(at, at + Vec3(size, 0, 0), at + Vec3(0, size, size)));
    }
  checked(scene_of(crowded));
}

// ---- The same bytes ----

TEST(Bvh, SameSceneSameBytesOnOneProcessorAndOnAll) {
  Scene scene;
  scene.file = "s";
  add_mesh(scene, teapot_mesh(24), Matrix(), Material::Checker, "s");
  const std::vector<std::uint8_t> bytes = compile(scene, 320, 240).bytes;
  EXPECT_EQ(compile(scene, 320, 240).bytes, bytes);
  std::vector<std::uint8_t> alone;
  std::jthread([&] {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(sched_getcpu(), &set);
    ASSERT_EQ(sched_setaffinity(0, sizeof set, &set), 0);
    alone = compile(scene, 320, 240).bytes;
  }).join();
  EXPECT_EQ(alone, bytes);
}

}  // namespace
}  // namespace castray::tb
