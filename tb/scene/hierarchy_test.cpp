// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The hierarchy against brute force on the scene files.
#include "hierarchy_check.hpp"
#include "scene_test.hpp"

namespace castray::tb {
namespace {

class SceneFiles : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, SceneFiles, testing::Values("cube", "spheres", "teapot", "teapot_fit", "teapot_flipped", "teapot_interior", "teapot_rotated",
                                                          "teapot_tight", "teapot_zoomed", "tiny"));
TEST_P(SceneFiles, HierarchyEqualsBruteForce) {
  const SceneImage image = compile(load_scene(std::string("scenes/") + GetParam() + ".json"), 320, 240);
  Hierarchy hierarchy(image, 1);
  hierarchy.run(image.header.primitives > 1000 ? 1000 : 20000);
  EXPECT_GT(hierarchy.totals.hits, hierarchy.totals.rays / 4);
}

}  // namespace
}  // namespace castray::tb
