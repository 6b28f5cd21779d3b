// SPDX-License-Identifier: Apache-2.0
// The device layer of a board on the Verilated core: what it gives equals the model's, whatever becomes of the interrupt;
// what cannot be done is refused before the start; a core that hangs is given up in time, and left idle where it can be.
// Cores: l1c32t3p1m0
#include "uio/board_device.hpp"

#include "comparison.hpp"
#include "frame_run.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"
#include "scene/ray_record.hpp"
#include "simulated_board.hpp"

namespace castray::tb {
namespace {

constexpr std::uint32_t bit(std::int64_t number) { return 1u << number; }

const SceneImage& cube() {
  static const SceneImage image = compile(load_scene("scenes/cube.json"), 40, 30);
  return image;
}

class BoardDevice : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    kernel_.emplace(folder_);
    core_ = std::make_shared<SimulatedCore>(*kernel_);
    options_ = kernel_->options();
    options_.patience.silence = std::chrono::milliseconds(300);
  }
  std::unique_ptr<sim::Device> open() const { return open_simulated(core_, options_); }

  void expect_frame(sim::Device& device, const sim::RenderOptions& options = {}) const {
    sim::Driver driver(device);
    driver.load(cube());
    const sim::Rendering rendering = driver.render(options);
    ASSERT_EQ(rendering.error, ErrNone);
    EXPECT_TRUE(sim::compare(rendering, sim::run_model(cube(), options)).equal());
    EXPECT_EQ(core_->rtl.violations(), 0u);
  }
  // No interrupt may come any more, and no job runs.
  void expect_idle() const {
    EXPECT_EQ(core_->rtl.read_reg(RegGie), 0u);
    EXPECT_EQ(core_->rtl.read_reg(RegIer), 0u);
    EXPECT_EQ(core_->rtl.read_reg(RegIsr), 0u);
    EXPECT_EQ(core_->rtl.read_reg(RegControl) & (bit(CtrlIdle) | bit(CtrlStart)), bit(CtrlIdle));
  }

  std::optional<KernelFiles> kernel_;
  std::shared_ptr<SimulatedCore> core_;
  sim::BoardOptions options_;
};

TEST_F(BoardDevice, FramesEqualTheModels) {
  {
    const auto device = open();
    expect_frame(*device);
    expect_frame(*device, {.mode = sim::Mode::kBrute});
    expect_frame(*device, {.mode = sim::Mode::kBvhRoot, .window = sim::PixelWindow{3, 5, 20, 19}});
    EXPECT_TRUE(says(device->description(), {"simulated core", "lanes 1,", "udmabuf0", "interrupt"}));
  }
  EXPECT_EQ(core_->starts, 3u);
  expect_idle();
}

TEST_F(BoardDevice, AListEqualsTheModels) {
  const auto device = open();
  sim::Driver driver(*device);
  driver.load(cube());
  std::vector<ray_record_t> rays(40);
  for (std::size_t i = 0; i < rays.size(); ++i)
    rays[i] = ray_record(cube(), {.origin = {4, 3, 5 - 0.1 * static_cast<double>(i)}, .direction = {-4, -3, -5}});
  const std::vector<std::uint8_t> records = sim::bytes_of(rays);
  const sim::Answers answers = driver.query(records), expected = sim::query_model(cube(), records);
  ASSERT_EQ(answers.error, ErrNone);
  EXPECT_EQ(answers.hits, expected.hits);
  EXPECT_GT(answers.counters[CntHits], 5u);
}

TEST_F(BoardDevice, ALostInterruptIsNoHang) {
  core_->without = sim::Irq::kSilent;
  const auto device = open();
  expect_frame(*device);
  EXPECT_TRUE(says(device->description(), {"polled, as no interrupt came"}));
  const unsigned waits = core_->waits;
  expect_frame(*device);
  EXPECT_EQ(core_->waits, waits) << "it is not waited for again";
}

TEST_F(BoardDevice, WithoutALineItPolls) {
  core_->without = sim::Irq::kNone;
  const auto device = open();
  expect_frame(*device);
  EXPECT_EQ(core_->waits, 1u);
  EXPECT_TRUE(says(device->description(), {"; polled"}));
}

TEST_F(BoardDevice, PollsWhenTold) {
  options_.patience.poll = true;
  expect_frame(*open());
  EXPECT_EQ(core_->waits, 0u);
}

TEST_F(BoardDevice, ASlowJobIsNoHang) {
  options_.patience = {std::chrono::milliseconds(20), true};
  const SceneImage teapot = compile(load_scene("scenes/teapot.json"), 10, 8);
  const auto device = open();
  sim::Driver driver(*device);
  driver.load(teapot);
  unsigned looks = 0;
  const sim::Rendering rendering = driver.render({.mode = sim::Mode::kBrute}, [&](double fraction, std::uint64_t cycles) {
    ++looks;
    EXPECT_LE(fraction, 1.0);
    EXPECT_GT(cycles, 0u);
  });
  EXPECT_EQ(rendering.error, ErrNone);
  EXPECT_GE(looks, 3u) << "the job took less than its patience";
}

TEST_F(BoardDevice, AnErrorOfTheJobLeavesTheCoreIdle) {
  SceneImage spoilt = cube();
  spoilt.bytes[8] ^= 0xff;  // its parameter word
  const auto device = open();
  {
    sim::Driver driver(*device);
    driver.load(spoilt);
    EXPECT_EQ(driver.render().error, ErrParameters);
  }
  expect_frame(*device);
}

// ---- What is not begun ----
TEST_F(BoardDevice, AnotherBuildIsRefusedUntouched) {
  for (const auto& [reg, value, word] : {std::tuple{RegVersion, 0x00ff0000u, "version"},
                                         {RegVersion, 0u, "version"},
                                         {RegParameters, 7u, "parameters"},
                                         {RegConfig, 0u, "configuration"},
                                         {RegConfig, 0x092003u, "configuration"}}) {
    core_->lies = {{static_cast<unsigned>(reg), value}};
    EXPECT_TRUE(says(refusal([&] { open(); }), {"simulated core", word, "load the bitstream"}));
  }
  EXPECT_TRUE(core_->written.empty());
}

TEST_F(BoardDevice, NothingStartsOutsideItsBuffers) {
  const auto device = open();
  sim::Driver driver(*device);
  driver.load(cube());
  const auto refused = [&](const std::string& window, auto&& spoil) {
    driver.prepare({});
    spoil();
    EXPECT_TRUE(says(refusal([&] { driver.go(); }), {"nothing was started", window}));
  };
  const std::uint64_t end = KernelFiles::kAddress + KernelFiles::kBytes;
  refused("frame buffer", [&] { driver.set(RegFrameBytes, 1 << 20); });
  refused("frame buffer", [&] { driver.set_pointer(RegFrame, 0x1000); });
  refused("frame buffer", [&] { driver.set_pointer(RegFrame, end); });
  refused("frame buffer", [&] { driver.set_pointer(RegFrame, end - 4096); });
  refused("hit buffer", [&] { driver.set_pointer(RegHits, KernelFiles::kAddress - 64); });
  refused("scene image", [&] { driver.set(RegImageBytes, ~0u); });
  EXPECT_EQ(core_->starts, 0u);
  expect_idle();
  EXPECT_EQ(driver.render().error, ErrNone);
}

TEST_F(BoardDevice, ABufferTooSmallIsRefused) {
  const auto device = open();
  sim::Driver driver(*device);
  const SceneImage large = compile(load_scene("scenes/cube.json"), 320, 240);
  EXPECT_TRUE(says(refusal([&] { driver.load(large); }),
                   {"udmabuf0", std::to_string(320 * 240 * 32), std::to_string(KernelFiles::kBytes), "larger"}));
  driver.load(cube());
  EXPECT_EQ(driver.render().error, ErrNone);
  std::vector<std::uint8_t> byte(1);
  EXPECT_TRUE(says(refusal([&] { device->write(KernelFiles::kAddress + KernelFiles::kBytes - 1, byte); }), {"never allocated"}));
  EXPECT_TRUE(says(refusal([&] { device->read(0, byte); }), {"never allocated"}));
}

TEST_F(BoardDevice, ABufferThatTheCoreCannotReachIsRefused) {
  KernelFiles::put(kernel_->buffer() / "phys_addr", "0x10000000000");
  EXPECT_TRUE(says(refusal([&] { open(); }), {"udmabuf0", "does not reach"}));
  KernelFiles::put(kernel_->buffer() / "phys_addr", "0x40000100");
  EXPECT_TRUE(says(refusal([&] { open(); }), {"udmabuf0", "does not reach"}));
}

// ---- What does not come back ----
TEST_F(BoardDevice, AJobThatNeverEndsIsGivenUp) {
  core_->deaf = true;
  for (const sim::Irq without : {sim::Irq::kRaised, sim::Irq::kNone}) {
    core_->without = without;
    const auto device = open();
    sim::Driver driver(*device);
    driver.load(cube());
    EXPECT_TRUE(says(refusal([&] { driver.render(); }), {"does not end", "300 ms", "idle again"}));
    expect_idle();
    core_->deaf = false;
    EXPECT_EQ(driver.render().error, ErrNone) << "it is usable again";
    core_->deaf = true;
  }
}

TEST_F(BoardDevice, ACoreThatStaysBusyIsSaidToBe) {
  const auto device = open();
  sim::Driver driver(*device);
  driver.load(cube());
  core_->deaf = true;
  core_->lies[RegControl] = bit(CtrlStart);
  EXPECT_TRUE(says(refusal([&] { driver.render(); }), {"does not end", "still busy", "bitstream"}));
  EXPECT_TRUE(says(refusal([&] { device->allocate(64); }), {"did not end", "bitstream"})) << "its memory may still be written";
  EXPECT_TRUE(says(refusal([&] { open(); }), {"busy", "bitstream"}));
}

TEST_F(BoardDevice, TheJobOfAnotherProgramIsAwaited) {
  {
    const auto device = open();
    sim::Driver driver(*device);
    driver.load(cube());
    driver.start({.mode = sim::Mode::kBrute});
  }  // left in the midst of it
  expect_idle();
  const auto device = open();
  expect_frame(*device);
  device->reset();
  EXPECT_EQ(core_->rtl.read_reg(RegFrameSize), 0u);
  expect_frame(*device);
}

}  // namespace
}  // namespace castray::tb
