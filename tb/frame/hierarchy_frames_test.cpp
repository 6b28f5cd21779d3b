// SPDX-License-Identifier: Apache-2.0
// Whole frames of the model, hierarchy against brute force: every pixel and every raw hit record, with the start of
// tiles and from the root, on every scene file and on made scenes of up to 100,000 primitives. At sizes that take
// a second each, or as large as CASTRAY_FRAMES says: 320 for 320x240.
// Long: CASTRAY_FRAMES=320
#include "frame/frame.hpp"
#include "scene/made_scenes.hpp"

namespace castray::tb {
namespace {

// A width whose brute-force frame takes few tests, or the one asked for.
int width_for(const Scene& scene) {
  if (const char* text = std::getenv("CASTRAY_FRAMES")) return std::atoi(text);
  const double pixels = 4e7 / double(scene.primitives());
  return std::clamp(static_cast<int>(std::sqrt(pixels * 4 / 3)) / 4 * 4, 16, 80);
}

void expect_same(const std::string& name, const Scene& scene) {
  const int width = width_for(scene), height = width * 3 / 4;
  const SceneImage image = compile(scene, width, height);
  const sim::Rendering brute = sim::run_model(image, {.mode = sim::Mode::kBrute});
  ASSERT_EQ(brute.error, ErrNone);
  std::size_t pixels = 0, hits = 0;
  for (const sim::Mode mode : {sim::Mode::kBvh, sim::Mode::kBvhRoot}) {
    const sim::Rendering tree = sim::run_model(image, {.mode = mode});
    ASSERT_EQ(tree.error, ErrNone);
    const sim::Comparison comparison = sim::compare(tree, brute);
    EXPECT_TRUE(comparison.equal()) << sim::kModeNames[static_cast<std::size_t>(mode)];
    pixels += comparison.pixels_differ, hits += comparison.hits_differ;
  }
  EXPECT_GT(brute.counters[CntHits], 0u);
  std::printf("%-16s %6zu primitives  %3dx%-3d  %5lu hits  %zu pixels and %zu hits differ\n", name.c_str(), scene.primitives(), width, height,
              static_cast<unsigned long>(brute.counters[CntHits]), pixels, hits);
}

class SceneFiles : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, SceneFiles, testing::ValuesIn(scene_names()), [](const auto& info) { return info.param; });
TEST_P(SceneFiles, HierarchyEqualsBruteForce) { expect_same(GetParam(), scene_of(GetParam())); }

TEST(MadeScenes, TeapotOf100kTriangles) { expect_same("teapot 40", made_teapot(40, "made").scene); }
TEST(MadeScenes, FieldOfTeapots) { expect_same("field 4x3 of 10", made_field(4, 3, 10, "made").scene); }
TEST(MadeScenes, ThousandsOfSpheres) { expect_same("spheres 4096", made_spheres(4096, 1).scene); }

}  // namespace
}  // namespace castray::tb
