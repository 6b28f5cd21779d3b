// SPDX-License-Identifier: Apache-2.0
// What the core does with illegal registers, bad images and errors on the bus: it stops with the
// right code, raises the interrupt, leaves nothing unanswered, and the next frame is good.
// Cores: l3c32t3p2m128
#include "frame/frame.hpp"
#include "mem/image.hpp"
#include "model_device.hpp"

namespace castray::tb {
namespace {

const SceneImage& good_image() {
  static const SceneImage image = compile(load_scene("scenes/spheres.json"), 24, 16);
  return image;
}

// Runs the job whose arguments are set.
sim::Rendering run(sim::Driver& driver) {
  driver.go();
  EXPECT_EQ(driver.device().wait_interrupt({}), sim::Wait::kInterrupt) << "no interrupt";
  return driver.finish();
}

void expect_good_frame(Core& core) {
  core.device.memory().set_faults({});
  expect_frame(core, good_image());
}

// ---- Registers ----
struct Register {
  const char* name;
  std::function<void(sim::Driver&)> spoil;
};
void PrintTo(const Register& entry, std::ostream* os) { *os << entry.name; }
const Register kRegisters[] = {
    {"WidthZero", [](auto& d) { d.set(RegFrameSize, 16 << 16); }},
    {"HeightZero", [](auto& d) { d.set(RegFrameSize, 24); }},
    {"WidthTooLarge", [](auto& d) { d.set(RegFrameSize, 4097 | 16 << 16); }},
    {"SizeStrayBit", [](auto& d) { d.set(RegFrameSize, 24 | 16 << 16 | 1 << 13); }},
    {"ImageUnaligned", [](auto& d) { d.set_pointer(RegImage, d.image_buffer().address + 64); }},
    {"FrameUnaligned", [](auto& d) { d.set_pointer(RegFrame, d.frame_buffer().address + 32); }},
    {"HitsUnaligned", [](auto& d) { d.set_pointer(RegHits, d.hits_buffer().address + 16); }},
    {"ImageAboveTheBus", [](auto& d) { d.set_pointer(RegImage, std::uint64_t{1} << 40); }},
    {"FramePastTheEnd", [](auto& d) { d.set_pointer(RegFrame, (std::uint64_t{1} << 40) - 64); }},
    {"ImageTooSmall", [](auto& d) { d.set(RegImageBytes, 255); }},
    {"UnknownOption", [](auto& d) { d.set(RegOptions, 1 << NumOptions); }},
    {"WindowEmpty", [](auto& d) { d.set(RegWindowMin, 5 | 5 << 16), d.set(RegWindowMax, 5 | 6 << 16); }},
    {"WindowReversed", [](auto& d) { d.set(RegWindowMin, 9 | 9 << 16), d.set(RegWindowMax, 3 | 12 << 16); }},
    {"WindowOutside", [](auto& d) { d.set(RegWindowMax, 25 | 16 << 16); }},
};
class IllegalRegisters : public testing::TestWithParam<Register> {};
INSTANTIATE_TEST_SUITE_P(Table, IllegalRegisters, testing::ValuesIn(kRegisters), [](const auto& info) { return std::string(info.param.name); });

TEST_P(IllegalRegisters, StopTheJobBeforeMemoryIsTouched) {
  Core core(core_of(3));
  core.driver.load(good_image());
  core.driver.set_arguments({});
  GetParam().spoil(core.driver);
  EXPECT_EQ(run(core.driver).error, ErrRegister);
  EXPECT_EQ(core.device.memory().counters().reads + core.device.memory().counters().writes, 0u);
  expect_good_frame(core);

  sim::ModelDevice model;
  sim::Driver driver(model);
  driver.load(good_image());
  driver.set_arguments({});
  GetParam().spoil(driver);
  EXPECT_EQ(run(driver).error, ErrRegister) << "the model";
}

// ---- Images ----
struct Bad {
  const char* name;
  error_t error;
  std::function<void(image_header_t&, frame_record_t&)> spoil;
};
void PrintTo(const Bad& entry, std::ostream* os) { *os << entry.name; }
const Bad kImages[] = {
    {"Magic", ErrImage, [](auto& h, auto&) { h.magic ^= 1; }},
    {"Version", ErrImage, [](auto& h, auto&) { h.version += 1; }},
    {"Parameters", ErrParameters, [](auto& h, auto&) { h.parameters ^= 256; }},
    {"Truncated", ErrSection, [](auto& h, auto&) { h.image_bytes += 1; }},
    {"LinesOutside", ErrSection, [](auto& h, auto&) { h.lines.count = 0xffffffff; }},
    {"AttributesOutside", ErrSection, [](auto& h, auto&) { h.attributes.offset = h.image_bytes + 255 & ~255ull; }},
    {"LinesUnaligned", ErrSection, [](auto& h, auto&) { h.lines.offset += 64; }},
    {"NoAttributes", ErrSection, [](auto& h, auto&) { h.primitives = h.attributes.count + 1; }},
    {"OtherSize", ErrFrameRecord, [](auto&, auto& f) { f.width += 1; }},
    {"Stride", ErrFrameRecord, [](auto&, auto& f) { f.stride += 4; }},
    {"StrideTooSmall", ErrFrameRecord, [](auto&, auto& f) { f.stride = 64; }},
    {"EyeOutside", ErrFrameRecord, [](auto&, auto& f) { f.eye_y = 1 << 26; }},
    {"PixelFormat", ErrFrameRecord, [](auto&, auto& f) { f.pixel_format = 2; }},
    {"FrameTooSmall", ErrFrameWindow, [](auto&, auto& f) { f.stride += 64; }},
};
class BadImages : public testing::TestWithParam<Bad> {};
INSTANTIATE_TEST_SUITE_P(Table, BadImages, testing::ValuesIn(kImages), [](const auto& info) { return std::string(info.param.name); });

SceneImage spoilt(const Bad& bad) {
  SceneImage image = good_image();
  image_header_t header = image.header;
  frame_record_t frame = image.frame;
  bad.spoil(header, frame);
  store_record(image.bytes.data(), header);
  store_record(image.bytes.data() + HeaderBytes, frame);
  return image;
}

TEST_P(BadImages, AreRefusedByCoreAndModel) {
  const SceneImage image = spoilt(GetParam());
  Core core(core_of(3, "uniform"));
  core.driver.load(image);
  EXPECT_EQ(core.driver.render().error, GetParam().error);
  EXPECT_EQ(core.device.memory().counters().writes, 0u);
  EXPECT_EQ(sim::run_model(image).error, GetParam().error) << "the model";
  expect_good_frame(core);
}

TEST(BadImages, PrimitiveNumberOutOfRange) {
  SceneImage image = good_image();
  prim_slot_t slot = load_slot(image.bytes.data(), image.header, 5);
  slot.number = image.header.primitives;
  store_record(image.bytes.data() + image.header.lines.offset + 5 * SlotBytes, slot);
  Core core(core_of(3, "uniform"));
  core.driver.load(image);
  EXPECT_EQ(core.driver.render().error, ErrPrimitive);
  EXPECT_EQ(sim::run_model(image).error, ErrPrimitive);
  expect_good_frame(core);
}

TEST(BadImages, HitBufferTooSmall) {
  Core core(core_of(3));
  core.driver.load(good_image());
  core.driver.set_arguments({});
  core.driver.set(RegHitsBytes, 24 * 16 * 32 - 1);
  EXPECT_EQ(run(core.driver).error, ErrHitWindow);
  expect_good_frame(core);
}

// ---- The bus ----
struct Fault {
  const char* name;
  error_t error;
  std::function<std::uint64_t(sim::Driver&)> address;
};
void PrintTo(const Fault& entry, std::ostream* os) { *os << entry.name; }
const Fault kFaults[] = {
    {"Header", ErrReadBus, [](auto& d) { return d.image_buffer().address + 16; }},
    {"FrameRecord", ErrReadBus, [](auto& d) { return d.image_buffer().address + 240; }},
    {"FirstPrimitive", ErrReadBus, [](auto& d) { return d.image_buffer().address + good_image().header.lines.offset; }},
    {"LastPrimitive", ErrReadBus,
     [](auto& d) { return d.image_buffer().address + good_image().header.lines.offset + 64 * good_image().header.lines.count - 16; }},
    {"Attributes", ErrReadBus, [](auto& d) { return d.image_buffer().address + good_image().header.attributes.offset; }},
    {"FirstPixel", ErrWriteBus, [](auto& d) { return d.frame_buffer().address; }},
    {"LastPixel", ErrWriteBus, [](auto& d) { return d.frame_buffer().address + 15 * good_image().frame.stride + 23 * 4; }},
    {"FirstHit", ErrWriteBus, [](auto& d) { return d.hits_buffer().address; }},
    {"LastHit", ErrWriteBus, [](auto& d) { return d.hits_buffer().address + (24 * 16 - 1) * 32; }},
};
class BusErrors : public testing::TestWithParam<Fault> {};
INSTANTIATE_TEST_SUITE_P(Table, BusErrors, testing::ValuesIn(kFaults), [](const auto& info) { return std::string(info.param.name); });

TEST_P(BusErrors, EndTheJobAndTheNextFrameWorks) {
  for (const std::string stalls : {"none", "uniform", "turn"}) {
    for (const sim::AxiResponse response : {sim::kSlvErr, sim::kDecErr}) {
      SCOPED_TRACE(stalls);
      Core core(core_of(3, stalls, 5));
      core.driver.load(good_image());
      // An attribute record that is asked for: all of them fail.
      const std::uint64_t bytes = std::string(GetParam().name) == "Attributes" ? 64 * good_image().header.attributes.count : 1;
      core.device.memory().set_faults({{GetParam().address(core.driver) / 16 * 16, bytes, response}});
      EXPECT_EQ(core.driver.render().error, GetParam().error);
      EXPECT_TRUE(core.device.memory().idle());
      EXPECT_TRUE(kept_the_rules(core.device));
      expect_good_frame(core);
    }
  }
}

TEST(BusErrors, WindowsWithoutMemory) {
  Core core(core_of(3));
  core.driver.load(good_image());
  core.driver.set_arguments({});
  core.driver.set_pointer(RegImage, 0x1000'0000);
  EXPECT_EQ(run(core.driver).error, ErrReadBus);
  core.driver.set_arguments({});
  core.driver.set_pointer(RegFrame, 0x1000'0000);
  EXPECT_EQ(run(core.driver).error, ErrWriteBus);
  expect_good_frame(core);
}

}  // namespace
}  // namespace castray::tb
