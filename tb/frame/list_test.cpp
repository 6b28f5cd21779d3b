// SPDX-License-Identifier: Apache-2.0
// Lists of rays on the core, in the hierarchy and by brute force: every record the model's, on 1 to 4
// lanes, under stalls, of any length, at any place.
// Cores: l1c32t3p1m0 l2c32t3p1m128 l3c32t3p2m128 l4c32t3p2m128
#include "frame/list.hpp"
#include "frame/random_scene.hpp"

namespace castray::tb {
namespace {

SceneImage image_of(const std::string& name, int width, int height) { return compile(load_scene("scenes/" + name), width, height); }

class Lists : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Lanes, Lists, testing::Values(1, 2, 3, 4));

TEST_P(Lists, RandomRaysInRandomScenesMatchTheModel) {
  static const char* const kStalls[] = {"none", "uniform", "bursty", "turn"};
  std::size_t yes = 0, no = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    const RandomScene random = random_scene(seed + 1000 * static_cast<unsigned>(GetParam()));
    SCOPED_TRACE(random.text);
    Core core(core_of(GetParam(), kStalls[seed % 4], seed));
    const SceneImage image = compile(random.scene, random.scene.width, random.scene.height);
    const std::vector<ray_record_t> rays = random_rays(image, 250 + seed, seed);
    ASSERT_NO_FATAL_FAILURE(expect_list(core, image, rays));
    const sim::Answers answers = sim::query_model(image, sim::bytes_of(rays));
    ASSERT_NO_FATAL_FAILURE(expect_any_is_nearest(image, rays, answers));
    for (std::size_t i = 0; i < rays.size(); ++i) (is_yes(answers.hit(i)) ? yes : no) += 1;
  }
  EXPECT_GT(yes, 1500u);
  EXPECT_GT(no, 1500u);
}

TEST_P(Lists, TheCamerasRaysGiveTheFramesRecords) {
  Core core(core_of(GetParam(), "uniform", 7));
  const SceneImage image = image_of("teapot.json", 48, 36);
  const std::vector<ray_record_t> rays = camera_rays(image);
  core.driver.load(image);
  const sim::Rendering frame = core.driver.render({.mode = sim::Mode::kBvhRoot});
  const sim::Answers answers = core.driver.query(sim::bytes_of(rays));
  ASSERT_EQ(frame.error, ErrNone);
  ASSERT_EQ(answers.error, ErrNone);
  EXPECT_TRUE(answers.hits == frame.hits);
  for (const auto counter : {CntTests, CntRays, CntHits, CntCandidates, CntNodes})
    EXPECT_EQ(answers.counters[static_cast<std::size_t>(counter)], frame.counters[static_cast<std::size_t>(counter)]) << counter;
  EXPECT_GT(answers.counters[CntHits], 300u);
}

TEST(List, OfAnyLengthAtAnyPlace) {
  Core core(core_of(1, "uniform", 3));
  const SceneImage image = image_of("spheres.json", 24, 16);
  const std::vector<ray_record_t> rays = random_rays(image, 140, 5);
  const sim::Answers model = sim::query_model(image, sim::bytes_of(rays));
  core.driver.load(image);
  for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 16u, 17u, 31u, 33u, 65u, 130u}) {
    for (std::size_t first = 0; first < 4; ++first) {
      SCOPED_TRACE(std::to_string(count) + " from " + std::to_string(first));
      core.driver.load_rays(sim::bytes_of(rays));
      core.driver.set_list_arguments({});
      core.driver.set_pointer(RegRays, core.driver.rays_buffer().address + first * RayBytes);
      core.driver.set(RegRayBytes, static_cast<std::uint32_t>(count * RayBytes));
      core.driver.set(RegRayCount, static_cast<std::uint32_t>(count));
      core.driver.set(RegHitsBytes, static_cast<std::uint32_t>(count * HitBytes));
      core.driver.go();
      ASSERT_EQ(core.device.wait_interrupt({}), sim::Wait::kInterrupt);
      const sim::Answers answers = core.driver.finish_query();
      ASSERT_EQ(answers.error, ErrNone);
      EXPECT_EQ(answers.counters[CntRays], count);
      for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(answers.hit(i) == model.hit(first + i)) << i;
      for (std::size_t i = count * HitBytes; i < answers.hits.size(); ++i) ASSERT_EQ(answers.hits[i], 0xa5) << "a write behind the answers";
      EXPECT_TRUE(kept_the_rules(core.device));
    }
  }
}

TEST(List, AndFramesTakeTurns) {
  Core core(core_of(3, "uniform", 4));
  const SceneImage image = image_of("spheres.json", 24, 16);
  const std::vector<ray_record_t> rays = random_rays(image, 150, 6);
  for (int i = 0; i < 3; ++i) {
    expect_frame(core, image, {.mode = i == 1 ? sim::Mode::kBrute : sim::Mode::kBvh});
    ASSERT_NO_FATAL_FAILURE(expect_list(core, image, rays));
  }
}

// A reset at any moment of a list; then a list or a frame is good.
TEST(List, AResetInTheMidstLeavesNothing) {
  const SceneImage image = image_of("spheres.json", 24, 16);
  const std::vector<ray_record_t> rays = random_rays(image, 120, 8);
  const std::vector<std::uint8_t> bytes = sim::bytes_of(rays);
  Core core(core_of(1, "uniform", 9));
  std::mt19937_64 rng(3);
  for (int i = 0; i < 24; ++i) {
    const sim::QueryOptions options{.mode = i % 2 ? sim::Mode::kBrute : sim::Mode::kBvhRoot};
    core.driver.load(image);
    core.driver.start(bytes, options);
    const std::uint64_t moment = rng() % (i % 3 ? 1500 : 500);
    ASSERT_FALSE(core.device.advance(moment)) << "the job was over before cycle " << moment;
    core.device.reset();
    EXPECT_FALSE(core.device.advance(200)) << "an interrupt after the reset";
    EXPECT_TRUE(core.device.memory().idle()) << "traffic after the reset";
    if (i % 4 == 3) expect_frame(core, image);
    else ASSERT_NO_FATAL_FAILURE(expect_list(core, image, rays));
  }
}

}  // namespace
}  // namespace castray::tb
