// SPDX-License-Identifier: Apache-2.0
// The model against the float64 reference, which never sees the image: how many pixels see another
// primitive, and colours within 1 of 255 where primitive and checker cell agree.
#include "frame/frame.hpp"
#include "frame/random_scene.hpp"
#include "reference_check.hpp"

namespace castray::tb {
namespace {

sim::ReferenceCheck check(const Scene& scene, int width, int height) {
  const SceneImage image = compile(scene, width, height);
  const sim::Rendering rendering = sim::run_model(image);
  EXPECT_EQ(rendering.error, ErrNone) << meaning(rendering.error);
  return sim::check_reference(scene, image, rendering, trace_float64(scene, width, height));
}

// The bar is so many of 76,800 pixels, and the same rate for other frames, rounded up.
void expect_rate(const sim::ReferenceCheck& check, std::size_t of_76800) {
  const std::size_t limit = (of_76800 * check.pixels + 76799) / 76800;
  EXPECT_LE(check.other_primitive, limit);
  EXPECT_LE(check.other_cell, 2 * limit);
  EXPECT_EQ(check.far_colour, 0u) << "worst channel " << check.worst;
  EXPECT_GT(check.hits, check.pixels / 20);
}

struct View {
  const char* scene;
  std::size_t limit;
};
void PrintTo(const View& view, std::ostream* os) { *os << view.scene; }
class Views : public testing::TestWithParam<View> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Views,
                         testing::Values(View{"teapot", 4}, View{"teapot_tight", 4}, View{"teapot_fit", 4}, View{"teapot_interior", 4},
                                         View{"teapot_rotated", 4}, View{"teapot_flipped", 4}, View{"teapot_zoomed", 4},
                                         View{"spheres", 8}, View{"cube", 4}),
                         [](const auto& info) { return std::string(info.param.scene); });

TEST_P(Views, SeeTheSamePrimitives) {
  const Scene scene = load_scene(std::string("scenes/") + GetParam().scene + ".json");
  expect_rate(check(scene, 80, 60), GetParam().limit);
}

class LargeFrames : public testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(Sizes, LargeFrames, testing::Values(std::pair{640, 480}, std::pair{1920, 1080}));
TEST_P(LargeFrames, SeeTheSamePrimitives) {
  const Scene scene = load_scene("scenes/tiny.json");
  expect_rate(check(scene, GetParam().first, GetParam().second), 8);
}

TEST(RandomScenesAgainstFloat64, OneInTenThousandPixelsAtMost) {
  sim::ReferenceCheck sum;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const RandomScene random = random_scene(seed);
    if (random.ties) continue;
    SCOPED_TRACE(random.text);
    const sim::ReferenceCheck one = check(random.scene, random.scene.width, random.scene.height);
    EXPECT_EQ(one.far_colour, 0u) << "worst channel " << one.worst;
    EXPECT_EQ(one.other_primitive, 0u);
    sum.pixels += one.pixels;
    sum.other_primitive += one.other_primitive;
  }
  EXPECT_GT(sum.pixels, 50'000u);
  EXPECT_LE(sum.other_primitive * 10'000, sum.pixels);
}

}  // namespace
}  // namespace castray::tb
