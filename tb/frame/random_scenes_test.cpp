// SPDX-License-Identifier: Apache-2.0
// 200 seeded random scenes, by brute force and in the hierarchy, RTL against model: every pixel, every
// raw hit record, the counters.
// Cores: l1c32t3p1m0 l2c32t3p1m128 l3c32t3p2m128 l4c32t3p2m128
#include "frame/frame.hpp"
#include "frame/random_scene.hpp"
#include "reference_check.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kScenes = 200;

class RandomScenes : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Lanes, RandomScenes, testing::Values(1, 2, 3, 4));

// All scenes on each number of lanes, under a pattern of stalls that changes with scene and lanes.
TEST_P(RandomScenes, MatchTheModel) {
  static const char* const kStalls[] = {"none", "uniform", "bursty", "turn"};
  const int lanes = GetParam();
  std::vector<std::unique_ptr<Core>> cores;
  for (const char* stalls : kStalls) cores.push_back(std::make_unique<Core>(core_of(lanes, stalls, static_cast<unsigned>(lanes))));
  for (unsigned seed = 0; seed < kScenes; ++seed) {
    const RandomScene random = random_scene(seed);
    const std::size_t core = (seed + static_cast<unsigned>(lanes)) % 4;
    SCOPED_TRACE(random.text + ", " + std::to_string(lanes) + " lanes, stalls " + kStalls[core]);
    const SceneImage image = compile(random.scene, random.scene.width, random.scene.height);
    sim::RenderOptions options;
    options.z_order = seed % 7 == 0;
    for (const sim::Mode mode : {sim::Mode::kBrute, seed % 4 == 0 ? sim::Mode::kBvhRoot : sim::Mode::kBvh}) {
      options.mode = mode;
      options.hits = mode == sim::Mode::kBrute || seed % 3 != 0;   // without, tiles of background are filled
      expect_frame(*cores[core], image, options);
    }
  }
}

// What the generator promises to cover.
TEST(RandomSceneMaker, CoversAxesAndHits) {
  std::size_t hits = 0, pixels = 0, spheres = 0, triangles = 0;
  std::map<std::string, int> axes;
  for (unsigned seed = 0; seed < kScenes; ++seed) {
    const RandomScene random = random_scene(seed);
    const std::size_t at = random.text.find("along ");
    ++axes[random.text.substr(at + 6, 2)];
    const ReferenceFrame frame = trace_float64(random.scene, random.scene.width, random.scene.height);
    pixels += frame.pixels.size();
    hits += frame.hits;
    for (const ReferencePixel& pixel : frame.pixels) {
      if (pixel.prim < 0) continue;
      (static_cast<std::size_t>(pixel.prim) < random.scene.triangles.size() ? triangles : spheres) += 1;
    }
  }
  EXPECT_EQ(axes.size(), 6u);
  for (const auto& [axis, count] : axes) EXPECT_GE(count, 20) << axis;
  EXPECT_GT(hits, pixels / 3);
  EXPECT_LT(hits, pixels);
  EXPECT_GT(triangles, pixels / 10);
  EXPECT_GT(spheres, pixels / 10);
}

}  // namespace
}  // namespace castray::tb
