// SPDX-License-Identifier: Apache-2.0
// The driver sees a device through registers and memory alone: here one that notes, and one that lies.
#include "driver.hpp"

#include <gtest/gtest.h>

#include <map>

#include "model_device.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

const SceneImage& image() {
  static const SceneImage image = compile(load_scene("scenes/cube.json"), 20, 15);
  return image;
}

// A device that answers with given registers instead of the model's, and never interrupts if told so.
class Liar : public sim::Device {
 public:
  std::string description() const override { return "liar"; }
  sim::Buffer allocate(std::uint64_t bytes) override {
    ++buffers;
    return model_.allocate(bytes);
  }
  void release(const sim::Buffer& buffer) override {
    --buffers;
    model_.release(buffer);
  }
  void write(std::uint64_t address, std::span<const std::uint8_t> bytes) override { model_.write(address, bytes); }
  void read(std::uint64_t address, std::span<std::uint8_t> bytes) override { model_.read(address, bytes); }
  void write_reg(unsigned offset, std::uint32_t value) override {
    written[offset] = value;
    model_.write_reg(offset, value);
  }
  std::uint32_t read_reg(unsigned offset) override { return lies.count(offset) ? lies[offset] : model_.read_reg(offset); }
  sim::Wait wait_interrupt(const sim::Progress& progress) override { return hangs ? sim::Wait::kHung : model_.wait_interrupt(progress); }
  void reset() override { model_.reset(); }

  std::map<unsigned, std::uint32_t> lies, written;
  bool hangs = false;
  int buffers = 0;

 private:
  sim::ModelDevice model_{1};
};

TEST(Driver, RefusesAnotherBuild) {
  Liar device;
  device.lies[RegVersion] = 0x990000;
  EXPECT_THROW(sim::Driver{device}, sim::DeviceError);
  device.lies = {{RegParameters, 1}};
  EXPECT_THROW(sim::Driver{device}, sim::DeviceError);
}

TEST(Driver, WritesTheArgumentsOfTheRegisterMap) {
  Liar device;
  sim::Driver driver(device);
  driver.load(image());
  driver.render({.hits = true, .z_order = true, .window = sim::PixelWindow{1, 2, 5, 9}});
  const auto pointer = [&](unsigned offset) { return device.written[offset] | std::uint64_t{device.written[offset + 4]} << 32; };
  EXPECT_EQ(pointer(RegImage), driver.image_buffer().address);
  EXPECT_EQ(pointer(RegFrame), driver.frame_buffer().address);
  EXPECT_EQ(pointer(RegHits), driver.hits_buffer().address);
  EXPECT_GT(pointer(RegImage), std::uint64_t{1} << 32) << "pointers have two words";
  EXPECT_EQ(device.written[RegImageBytes], image().bytes.size());
  EXPECT_EQ(device.written[RegFrameBytes], image().frame.stride * 15);
  EXPECT_EQ(device.written[RegHitsBytes], 20u * 15 * 32);
  EXPECT_EQ(device.written[RegFrameSize], 20u | 15u << 16);
  EXPECT_EQ(device.written[RegOptions], 3u);
  EXPECT_EQ(device.written[RegWindowMin], 1u | 2u << 16);
  EXPECT_EQ(device.written[RegWindowMax], 5u | 9u << 16);
}

TEST(Driver, ReportsAHang) {
  Liar device;
  sim::Driver driver(device);
  driver.load(image());
  device.hangs = true;
  EXPECT_THROW(driver.render(), sim::DeviceError);
  device.hangs = false;
  device.lies[RegControl] = 0;
  EXPECT_THROW(driver.render(), sim::DeviceError) << "an interrupt without done";
}

TEST(Driver, ReportsTheErrorRegister) {
  Liar device;
  sim::Driver driver(device);
  driver.load(image());
  device.lies[RegError] = ErrReadBus;
  EXPECT_EQ(driver.render().error, ErrReadBus);
}

TEST(Driver, UnwrittenPixelsAreNoPixels) {
  sim::ModelDevice device;
  sim::Driver driver(device);
  driver.load(image());
  const sim::Rendering part = driver.render({.mode = sim::Mode::kBvhRoot, .window = sim::PixelWindow{3, 3, 4, 4}});
  EXPECT_EQ(part.pixels[part.index(3, 3)] >> 24, 255u);
  EXPECT_EQ(part.pixels[part.index(4, 3)], 0xa5a5a5a5u);
  EXPECT_EQ(part.counters[CntRays], 1u);
}

TEST(Driver, GivesItsBuffersBack) {
  Liar device;
  {
    sim::Driver driver(device);
    driver.load(image());
    driver.load(image());
    EXPECT_EQ(device.buffers, 3);
  }
  EXPECT_EQ(device.buffers, 0);
}

TEST(ModelDevice, FollowsTheProtocolOfTheRegisterMap) {
  sim::ModelDevice device;
  EXPECT_EQ(device.read_reg(RegControl), 1u << CtrlIdle);
  sim::Driver driver(device);
  driver.load(image());
  driver.start({});
  EXPECT_EQ(device.read_reg(RegControl), 1u << CtrlStart);
  EXPECT_EQ(device.wait_interrupt({}), sim::Wait::kInterrupt);
  EXPECT_EQ(device.read_reg(RegIsr), 1u << IsrDone);
  const std::uint32_t done = 1u << CtrlDone | 1u << CtrlReady | 1u << CtrlIdle;
  EXPECT_EQ(device.read_reg(RegControl), done | 1u << CtrlInterrupt);
  EXPECT_EQ(device.read_reg(RegControl) & done, 1u << CtrlIdle) << "done is cleared by reading";
  device.write_reg(RegIsr, 1u << IsrDone);
  EXPECT_EQ(device.read_reg(RegIsr), 0u);
  EXPECT_EQ(device.wait_interrupt({}), sim::Wait::kHung) << "nothing was started";
}

}  // namespace
}  // namespace castray::tb
