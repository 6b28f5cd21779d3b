// SPDX-License-Identifier: Apache-2.0
// Spoilt scene images through the core, frames and lists of rays: every job ends, as the model's does or with an error that some ray or tile
// of it has; what ends well is equal in every pixel, hit record and counter; nothing outside the windows is
// touched; and the job behind it, on the good image, gives the right picture.
// Cores: l1c32t3p1m0
// Long: CASTRAY_IMAGES=1000
#include "core.hpp"
#include "frame/frame.hpp"
#include "frame/spoilt_list.hpp"
#include "model_device.hpp"

namespace castray::tb {
namespace {

constexpr std::array kModes{sim::Mode::kBrute, sim::Mode::kBvhRoot, sim::Mode::kBvh};

// What is known of a job before the core runs it.
struct Expected {
  sim::Rendering rendering;
  std::uint32_t errors = 0;   // a bit for each code that the core may report
};

// Runs the spoilt job up to its interrupt.
sim::Rendering run(sim::Driver& driver, const Spoilt& spoilt, const sim::RenderOptions& options) {
  driver.load(spoilt.image);
  driver.prepare(options);
  driver.set(RegImageBytes, static_cast<std::uint32_t>(spoilt.window));
  driver.go();
  EXPECT_EQ(driver.device().wait_interrupt({}), sim::Wait::kInterrupt) << "no interrupt";
  return driver.finish();
}

Expected expect(const Spoilt& spoilt, const sim::RenderOptions& options) {
  sim::ModelDevice device(1);
  sim::Driver driver(device);
  Expected expected{.rendering = run(driver, spoilt, options)};
  if (expected.rendering.error != ErrNone)
    expected.errors = run_job(device.job(), device.windows(device.job()), {.threads = 1, .every_error = true}).errors;
  return expected;
}

const sim::Rendering& good(unsigned which, unsigned mode) {
  static std::map<std::pair<unsigned, unsigned>, sim::Rendering> known;
  const auto [at, is_new] = known.try_emplace({which, mode});
  if (is_new) at->second = sim::run_model(image_to_spoil(which), {.mode = kModes[mode]}, {}, 1);
  return at->second;
}

TEST(SpoiltImages, EndEveryJobOfTheCoreAndTheNextOneIsGood) {
  const unsigned count = images_to_spoil(120);
  std::vector<std::unique_ptr<Core>> cores;
  for (const char* stalls : {"none", "uniform", "bursty"}) cores.push_back(std::make_unique<Core>(core_of(1, stalls, 21)));
  SpoiltCounts counts;
  for (unsigned seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    const Spoilt spoilt = Spoiler(seed).make();
    const unsigned mode = seed / 2 % 3;
    SCOPED_TRACE(spoilt.text + ", " + sim::kModeNames[static_cast<std::size_t>(kModes[mode])] + ", steps " + std::to_string(spoilt.steps));
    const sim::RenderOptions options{.hits = seed % 5 != 0, .mode = kModes[mode], .steps = spoilt.steps};
    const Expected expected = expect(spoilt, options);
    Core& core = *cores[seed % 8 == 0 ? 1 + seed / 8 % 2 : 0];
    const sim::Rendering rtl = run(core.driver, spoilt, options);
    counts.count(seed, rtl.error);
    if (expected.rendering.error == ErrNone) {
      EXPECT_TRUE(equal(rtl, expected.rendering));
    } else {
      EXPECT_TRUE(expected.errors >> rtl.error & 1) << meaning(rtl.error) << "; the model: " << meaning(expected.rendering.error);
    }
    EXPECT_TRUE(core.device.memory().idle());
    core.driver.load(image_to_spoil(seed));
    EXPECT_TRUE(equal(core.driver.render({.mode = kModes[mode]}), good(seed % 8, mode))) << "the good image behind it";
    EXPECT_TRUE(kept_the_rules(core.device));
  }
  std::printf("%u images, %u of them end well\n", count, counts.of(ErrNone));
  for (const error_t error : {ErrRegister, ErrImage, ErrParameters, ErrSection, ErrFrameRecord, ErrPrimitive, ErrNode, ErrLeaf, ErrStack, ErrSteps}) {
    std::printf("  %5u  %s\n", counts.of(error), meaning(error));
    EXPECT_GE(counts.of(error), count / 1000) << "too few of error " << error;
  }
}

// Runs the list on the spoilt image up to its interrupt.
sim::Answers run_list(sim::Driver& driver, const Spoilt& spoilt, std::span<const std::uint8_t> rays, const sim::QueryOptions& options) {
  driver.load(spoilt.image);
  driver.load_rays(rays);
  driver.set_list_arguments(options);
  driver.set(RegImageBytes, static_cast<std::uint32_t>(spoilt.window));
  driver.go();
  EXPECT_EQ(driver.device().wait_interrupt({}), sim::Wait::kInterrupt) << "no interrupt";
  return driver.finish_query();
}

TEST(SpoiltImages, EndEveryListOfTheCoreAndTheNextOneIsGood) {
  const unsigned count = images_to_spoil(120);
  std::vector<std::unique_ptr<Core>> cores;
  for (const char* stalls : {"none", "bursty"}) cores.push_back(std::make_unique<Core>(core_of(1, stalls, 22)));
  SpoiltCounts counts;
  for (unsigned seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    const Spoilt spoilt = Spoiler(seed).make();
    const std::vector<std::uint8_t> rays = rays_for(spoilt, seed);
    const sim::QueryOptions options{.mode = seed / 2 % 3 == 0 ? sim::Mode::kBrute : sim::Mode::kBvhRoot, .steps = spoilt.steps};
    SCOPED_TRACE(spoilt.text + ", a list, " + sim::kModeNames[static_cast<std::size_t>(options.mode)]);
    sim::ModelDevice device(1);
    sim::Driver driver(device);
    const sim::Answers expected = run_list(driver, spoilt, rays, options);
    Core& core = *cores[seed % 8 == 0];
    const sim::Answers rtl = run_list(core.driver, spoilt, rays, options);
    counts.count(seed, rtl.error);
    if (expected.error == ErrNone) {
      EXPECT_EQ(rtl.error, ErrNone);
      EXPECT_TRUE(rtl.hits == expected.hits);
    } else {
      const Outcome all = run_job(device.job(), device.windows(device.job()), {.threads = 1, .every_error = true});
      EXPECT_TRUE(all.errors >> rtl.error & 1) << meaning(rtl.error) << "; the model: " << meaning(expected.error);
    }
    EXPECT_TRUE(core.device.memory().idle());
    const std::vector<std::uint8_t> sound = rays_for(spoilt, 2 * seed);   // an even seed: no bit of it is spoilt
    const SceneImage& image = image_to_spoil(seed);
    core.driver.load(image);
    EXPECT_TRUE(core.driver.query(sound).hits == sim::query_model(image, sound).hits) << "the good image behind it";
    EXPECT_TRUE(kept_the_rules(core.device));
  }
  std::printf("%u lists, %u of them end well\n", count, counts.of(ErrNone));
  EXPECT_GT(counts.of(ErrNone), count / 20);
  EXPECT_GT(counts.of(ErrNode), 0u);
}

}  // namespace
}  // namespace castray::tb
