// SPDX-License-Identifier: Apache-2.0
// In the model: a ray through the hierarchy hits what it hits by brute force, bit for bit; any hit is found
// exactly where there is one. CASTRAY_RAYS: so many rays, through 1,000 random scenes.
// Long: CASTRAY_RAYS=10000000 --gtest_filter=RandomScenes.*
#include <cstdlib>

#include "../frame/random_scene.hpp"
#include "ray_maker.hpp"
#include "scene_test.hpp"
#include "traverse/lane.hpp"

namespace castray::tb {
namespace {

struct Totals {
  long rays = 0, hits = 0, any_hits = 0, nodes = 0, tests = 0;
};

class Hierarchy {
 public:
  Hierarchy(const SceneImage& image, unsigned seed)
      : maker_(image, seed), tree_{.image = image.bytes.data(), .header = &image.header, .limit = 10000000} {}

  // Also with limits around the hit, and without the primitive hit.
  void run(int rays) {
    for (int i = 0; i < rays; ++i) {
      const ray_t ray = maker_.make();
      const hit_t hit = expect_same(ray);
      if (testing::Test::HasFailure()) return;
      if (hit.found && maker_.one_in(2)) expect_same(maker_.around(ray, hit.t, hit.number));
    }
  }
  Totals totals;

 private:
  hit_t expect_same(const ray_t& ray) {
    const auto ignore = [](const cand_t&, const result_t*) {};
    std::uint64_t tests = 0;
    const hit_t brute = lane(ray, maker_.slots(), tests, ignore);
    const TreeHit tree = lane(ray, tree_, tree_.root(), ignore);
    EXPECT_EQ(tree.error, ErrNone) << to_text(ray);
    if (ray.any_hit) EXPECT_EQ(tree.hit.found, brute.found) << to_text(ray);
    else if (!(tree.hit == brute)) ADD_FAILURE() << to_text(ray) << "\n" << to_text(tree.hit) << "\nbrute force " << to_text(brute);
    EXPECT_LE(tree.work.tests, tests);
    ++totals.rays;
    totals.hits += static_cast<long>(brute.found);
    totals.any_hits += brute.found && ray.any_hit;
    totals.nodes += static_cast<long>(tree.work.nodes), totals.tests += static_cast<long>(tree.work.tests);
    return brute;
  }
  RayMaker maker_;
  Tree tree_;
};

class SceneFiles : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, SceneFiles, testing::Values("cube", "spheres", "teapot", "teapot_fit", "teapot_flipped", "teapot_interior", "teapot_rotated",
                                                          "teapot_tight", "teapot_zoomed", "tiny"));
TEST_P(SceneFiles, HierarchyEqualsBruteForce) {
  const SceneImage image = compile(load_scene(std::string("scenes/") + GetParam() + ".json"), 320, 240);
  Hierarchy hierarchy(image, 1);
  hierarchy.run(image.header.primitives > 1000 ? 1000 : 20000);
  EXPECT_GT(hierarchy.totals.hits, hierarchy.totals.rays / 4);
}

TEST(RandomScenes, HierarchyEqualsBruteForce) {
  const char* text = std::getenv("CASTRAY_RAYS");
  const long rays = text ? std::atol(text) : 200000, scenes = text ? 1000 : 200;
  Totals all;
  for (unsigned seed = 0; seed < scenes && !HasFailure(); ++seed) {
    const RandomScene random = random_scene(seed);
    const SceneImage image = compile(random.scene, random.scene.width, random.scene.height);
    SCOPED_TRACE(random.text);
    Hierarchy hierarchy(image, seed);
    hierarchy.run(static_cast<int>(rays / scenes));
    all.rays += hierarchy.totals.rays, all.hits += hierarchy.totals.hits, all.any_hits += hierarchy.totals.any_hits;
  }
  EXPECT_GT(all.hits, all.rays / 4);
  EXPECT_GT(all.any_hits, all.rays / 40);
  std::printf("%ld rays, %ld hits\n", all.rays, all.hits);
}

}  // namespace
}  // namespace castray::tb
