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
  core.driver.load(image);
  const std::uint64_t cycles = core.driver.render().cycles();
  std::mt19937_64 random(17);
  std::uint64_t dropped = 0;
  for (int i = 0; i < 30; ++i) {
    core.driver.load(image);
    core.driver.start({});
    // A third of them early: while header, frame record and the first primitives are read.
    const std::uint64_t moment = random() % (i % 3 == 0 ? 400 : cycles);
    SCOPED_TRACE("reset " + std::to_string(moment) + " cycles after the start");
    ASSERT_FALSE(core.device.advance(moment)) << "the job was over";
    core.device.reset();
    dropped += core.device.memory().counters().dropped;
    EXPECT_FALSE(core.device.advance(200)) << "an interrupt after the reset";
    EXPECT_TRUE(core.device.memory().idle()) << "traffic after the reset";
    expect_frame(core, image);
  }
  EXPECT_GT(dropped, 5u) << "no reset fell into a burst";
}

}  // namespace
}  // namespace castray::tb
