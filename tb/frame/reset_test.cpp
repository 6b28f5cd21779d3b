// SPDX-License-Identifier: Apache-2.0
// A reset at any moment, in the midst of bursts too: the next frame is good.
// Cores: l3c32t3p2m128
#include "frame/frame.hpp"

namespace castray::tb {
namespace {

class Reset : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Stalls, Reset, testing::Values("none", "uniform", "turn"), [](const auto& info) { return info.param; });

TEST_P(Reset, AtAnyMomentTheNextFrameWorks) {
  const SceneImage image = compile(load_scene("scenes/spheres.json"), 24, 16);
  Core core(core_of(3, GetParam(), 9));
  std::array<std::uint64_t, 2> cycles{};
  const std::array<sim::RenderOptions, 2> jobs{{{.mode = sim::Mode::kBrute}, {.mode = sim::Mode::kBvh}}};
  core.driver.load(image);
  for (std::size_t job = 0; job < jobs.size(); ++job) cycles[job] = core.driver.render(jobs[job]).cycles();
  std::mt19937_64 random(17);
  std::uint64_t dropped = 0;
  for (int i = 0; i < 30; ++i) {
    core.driver.load(image);
    const auto job = static_cast<std::size_t>(i % 2);
    core.driver.start(jobs[job]);
    // A third of them early: while header, frame record and the first primitives are read.
    // The stalls are others in each job, and so is its length.
    const std::uint64_t moment = random() % (i % 3 == 0 ? 400 : cycles[job] * 2 / 3);
    SCOPED_TRACE("reset " + std::to_string(moment) + " cycles after the start");
    ASSERT_FALSE(core.device.advance(moment)) << "the job was over";
    core.device.reset();
    dropped += core.device.memory().counters().dropped;
    EXPECT_FALSE(core.device.advance(200)) << "an interrupt after the reset";
    EXPECT_TRUE(core.device.memory().idle()) << "traffic after the reset";
    expect_frame(core, image, jobs[job]);
  }
  EXPECT_GT(dropped, 5u) << "no reset fell into a burst";
}

}  // namespace
}  // namespace castray::tb
