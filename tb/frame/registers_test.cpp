// SPDX-License-Identifier: Apache-2.0
// The start/done protocol on a whole core: what is written while a job runs, jobs that follow one
// another by themselves, waiting with and without the interrupt.
// Cores: l1c32t3p1m0
#include "frame/frame.hpp"

namespace castray::tb {
namespace {

constexpr int kWidth = 24, kHeight = 16;
constexpr std::uint32_t kStart = 1u << CtrlStart, kDone = 1u << CtrlDone, kIdle = 1u << CtrlIdle, kRestart = 1u << CtrlAutoRestart;
constexpr std::uint64_t kLong = 200'000;  // cycles, more than any of these jobs takes

class Registers : public testing::Test {
 protected:
  void SetUp() override {
    core_.driver.load(image_);
    core_.driver.start({});
  }
  std::uint32_t control() { return core_.device.read_reg(RegControl); }
  // Lets the job run to its end by looking at the control register alone; the bits seen then.
  std::uint32_t poll() {
    for (std::uint64_t cycles = 0; cycles < kLong; cycles += 100) {
      if (const std::uint32_t bits = control(); bits & kDone) return bits;
      core_.device.advance(100);
    }
    ADD_FAILURE() << "the job does not end";
    return 0;
  }
  // Takes the interrupt back; the picture is that of the model.
  void expect_done() {
    EXPECT_TRUE(equal(core_.driver.finish(), sim::run_model(image_)));
    EXPECT_TRUE(kept_the_rules(core_.device));
  }

  const SceneImage image_ = compile(load_scene("scenes/spheres.json"), kWidth, kHeight);
  Core core_{core_of(1, "uniform")};
};

TEST_F(Registers, ArgumentsOfARunningJobAreItsOwn) {
  core_.device.advance(300);
  for (const auto reg : {RegImageBytes, RegFrameBytes, RegHitsBytes, RegFrameSize, RegOptions, RegWindowMin, RegWindowMax, RegSteps})
    core_.driver.set(reg, 0xffffffff);
  for (const auto reg : {RegImage, RegFrame, RegHits}) core_.driver.set_pointer(reg, ~std::uint64_t{0});
  ASSERT_TRUE(core_.device.advance(kLong));
  expect_done();
  core_.driver.go();  // what was written counts for the next one
  ASSERT_TRUE(core_.device.advance(kLong));
  EXPECT_EQ(core_.driver.finish().error, ErrRegister);
  expect_frame(core_, image_);
}

TEST_F(Registers, AStartOfARunningJobIsNone) {
  for (int i = 0; i < 3; ++i) {
    core_.device.advance(200);
    core_.device.write_reg(RegControl, kStart);
  }
  EXPECT_EQ(control() & (kStart | kIdle), kStart);
  ASSERT_TRUE(core_.device.advance(kLong));
  expect_done();
  EXPECT_FALSE(core_.device.advance(20'000)) << "another job was run";
  EXPECT_EQ(control() & (kStart | kIdle), kIdle);
}

TEST_F(Registers, ReadOnlyOnesTakeNoWrites) {
  for (const auto reg : {RegVersion, RegConfig, RegParameters, RegError, RegCounters, RegCounters + 4}) {
    const std::uint32_t before = core_.device.read_reg(static_cast<unsigned>(reg));
    core_.driver.set(reg, ~before);
    if (reg != RegCounters) EXPECT_EQ(core_.device.read_reg(static_cast<unsigned>(reg)), before) << reg;
  }
  ASSERT_TRUE(core_.device.advance(kLong));
  expect_done();
}

TEST_F(Registers, WithoutTheInterruptDoneIsPolled) {
  core_.driver.set(RegGie, 0);
  EXPECT_FALSE(core_.device.advance(kLong)) << "an interrupt that nobody enabled";
  EXPECT_EQ(core_.device.read_reg(RegIsr), 1u << IsrDone) << "the end is noted";
  EXPECT_EQ(poll() & (kStart | kDone | kIdle), kDone | kIdle);
  EXPECT_EQ(control() & kDone, 0u) << "done was read";
  core_.driver.set(RegGie, 1);
  EXPECT_TRUE(core_.device.advance(1)) << "enabled behind the end";
}

TEST_F(Registers, AMaskedEndIsNotNoted) {
  core_.driver.set(RegIer, 1u << IsrReady);
  ASSERT_TRUE(core_.device.advance(kLong));
  EXPECT_EQ(core_.device.read_reg(RegIsr), 1u << IsrReady);
  core_.driver.set(RegIsr, 1u << IsrReady);
  EXPECT_FALSE(core_.device.advance(1));
  core_.driver.set(RegIer, 0);
  core_.driver.set(RegControl, kStart);
  EXPECT_NE(poll(), 0u);
  EXPECT_EQ(core_.device.read_reg(RegIsr), 0u);
}

// The left half, then, by itself, the right one: its window is written while the left is rendered.
TEST_F(Registers, AutoRestartTakesTheArgumentsOfTheNextJob) {
  core_.device.reset();
  core_.driver.set_arguments({.hits = true, .z_order = false, .window = sim::PixelWindow{0, 0, 9, kHeight}});
  core_.driver.set(RegIer, 1u << IsrDone);
  core_.driver.set(RegGie, 1);
  core_.device.write_reg(RegControl, kStart | kRestart);
  core_.device.advance(100);
  core_.driver.set(RegWindowMin, 9);
  core_.driver.set(RegWindowMax, kWidth | kHeight << 16);
  ASSERT_TRUE(core_.device.advance(kLong));
  core_.driver.set(RegIsr, 1u << IsrDone);
  EXPECT_EQ(control() & (kStart | kIdle | kRestart), kStart | kRestart) << "the next one runs";
  core_.device.write_reg(RegControl, 0);
  ASSERT_TRUE(core_.device.advance(kLong));
  sim::Rendering both = core_.driver.finish();
  EXPECT_FALSE(core_.device.advance(20'000)) << "a third job was run";
  sim::Rendering model = sim::run_model(image_);
  both.counters = model.counters;  // those of the right half alone
  EXPECT_TRUE(equal(both, model));
  EXPECT_TRUE(kept_the_rules(core_.device));
}

// A job that fails restarts as any other; its code is seen while the next one has not begun.
TEST_F(Registers, AutoRestartOutlivesErrors) {
  core_.device.reset();
  core_.driver.set_arguments({});
  core_.driver.set(RegFrameSize, 0);
  core_.device.write_reg(RegControl, kStart | kRestart);
  core_.device.advance(2'000);
  EXPECT_EQ(control() & (kStart | kDone | kIdle), kStart | kDone);
  core_.driver.set_arguments({});
  core_.device.advance(200);
  core_.device.write_reg(RegControl, 0);
  while (!(control() & kIdle)) core_.device.advance(100);
  core_.driver.go();
  ASSERT_TRUE(core_.device.advance(kLong));
  expect_done();
}

TEST_F(Registers, AResetClearsThemAll) {
  core_.device.write_reg(RegControl, kRestart);
  ASSERT_TRUE(core_.device.advance(kLong));
  core_.device.reset();
  EXPECT_FALSE(core_.device.advance(20'000)) << "an interrupt or another job";
  EXPECT_EQ(control(), kIdle);
  for (const auto reg : {RegGie, RegIer, RegIsr, RegImage, RegFrame, RegHits, RegFrameSize, RegWindowMax, RegSteps, RegError, RegCounters})
    EXPECT_EQ(core_.device.read_reg(static_cast<unsigned>(reg)), 0u) << reg;
  expect_frame(core_, image_);
}

}  // namespace
}  // namespace castray::tb
