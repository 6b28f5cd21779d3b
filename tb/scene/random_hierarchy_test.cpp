// SPDX-License-Identifier: Apache-2.0
// The hierarchy against brute force in random scenes. CASTRAY_RAYS: so many rays, through 1,000 of them.
// tb/cli/widths.sh builds it for other widths too.
// Long: CASTRAY_RAYS=10000000
#include "../frame/random_scene.hpp"
#include "hierarchy_check.hpp"

namespace castray::tb {
namespace {

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
    expect_same_frame(image);
    all.rays += hierarchy.totals.rays, all.hits += hierarchy.totals.hits, all.any_hits += hierarchy.totals.any_hits;
  }
  EXPECT_GT(all.hits, all.rays / 4);
  EXPECT_GT(all.any_hits, all.rays / 40);
  std::printf("%ld rays, %ld hits\n", all.rays, all.hits);
}

}  // namespace
}  // namespace castray::tb
