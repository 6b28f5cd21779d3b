// SPDX-License-Identifier: Apache-2.0
// frame_setup: equal to its model, ties and extremes by hand, 136 cycles.
#include "Vframe_setup.h"
#include "camera/frame_setup.hpp"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr std::uint64_t kOne = std::uint64_t{1} << ScaleFrac;
constexpr int kCycles = 136;

class FrameSetup : public ::testing::Test {
 protected:
  // Runs a start to its done; `cycles` counts from the cycle of the start.
  camera_t run(const frame_record_t& record, int* cycles = nullptr) {
    dut->start_i = 1;
    set_port(dut->record_i, record);
    dut.tick();
    dut->start_i = 0;
    int count = 1;
    for (; !dut->done_o && count < 1000; ++count) dut.tick();
    EXPECT_TRUE(dut->done_o);
    if (cycles) *cycles = count;
    return get_port<camera_t>(dut->camera_o);
  }
  void expect_model(const frame_record_t& record) {
    const camera_t got = run(record), want = frame_setup(record);
    EXPECT_TRUE(got == want) << "record " << to_text(record) << "\n rtl   " << to_text(got) << "\n model " << to_text(want);
  }
  static void set_elements(frame_record_t& record, std::int64_t element) {
    record.right_x = record.right_y = record.right_z = element;
    record.up_x = record.up_y = record.up_z = element;
    record.back_x = record.back_y = record.back_z = element;
  }

  Dut<Vframe_setup> dut;
};

TEST_F(FrameSetup, MatchesModel) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 2000; ++i) {
    packed_t<frame_record_t> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(rng());
    expect_model(unpack<frame_record_t>(words.data()));
  }
}

TEST_F(FrameSetup, RoundsHalvesUpAndThenTakesTheSign) {
  // A product of half a last bit: 2^31 in units of 2^-74.
  for (const auto& [element, step, ahead] : {std::array{1, 1, -1}, {-1, 0, 0}, {3, 2, -2}, {-3, -1, 1}, {2, 1, -1}, {-2, -1, 1}}) {
    frame_record_t record;
    set_elements(record, element);
    record.pitch = record.focal = std::uint64_t{1} << 31;
    const camera_t camera = run(record);
    for (const auto got : {camera.right.x, camera.right.y, camera.right.z, camera.up.x, camera.up.y, camera.up.z}) EXPECT_EQ(got, step);
    for (const auto got : {camera.ahead.x, camera.ahead.y, camera.ahead.z}) EXPECT_EQ(got, ahead);
    expect_model(record);
    record.pitch = record.focal -= 1;  // just below the half
    expect_model(record);
  }
}

TEST_F(FrameSetup, KeepsExtremes) {
  for (const std::int64_t element : {INT64_C(-2147483648), INT64_C(2147483647), INT64_C(1) << 30, INT64_C(0), INT64_C(-1)})
    for (const std::uint64_t scale : {kOne - 1, kOne / 2, std::uint64_t{1}, std::uint64_t{0}, ~std::uint64_t{0}}) {
      frame_record_t record;
      set_elements(record, element);
      record.pitch = scale;
      record.focal = scale;
      record.eye_x = record.eye_z = (1u << CoordW) - 1;
      record.width = record.height = 4096;
      expect_model(record);
    }
}

TEST_F(FrameSetup, OfTheIdentityIsTheScale) {
  frame_record_t record;
  record.right_x = record.up_y = record.back_z = 1 << RotFrac;
  record.pitch = 5 << 2;
  record.focal = 9 << 2;
  const camera_t camera = run(record);
  EXPECT_EQ(camera.right.x, 5);
  EXPECT_EQ(camera.up.y, 5);
  EXPECT_EQ(camera.ahead.z, -9);
  EXPECT_EQ(camera.right.y | camera.right.z | camera.up.x | camera.up.z | camera.ahead.x | camera.ahead.y, 0);
}

TEST_F(FrameSetup, Takes136CyclesAndHoldsDone) {
  EXPECT_FALSE(dut->done_o) << "done before the first start";
  int cycles = 0;
  frame_record_t record;
  run(record, &cycles);
  EXPECT_EQ(cycles, kCycles);
  for (int i = 0; i < 300; ++i) dut.tick();
  EXPECT_TRUE(dut->done_o);
  dut->start_i = 1;
  dut.tick();
  dut->start_i = 0;
  dut.settle();
  EXPECT_FALSE(dut->done_o) << "a start takes done away";
}

TEST_F(FrameSetup, StartsAfreshAtAnyMoment) {
  std::mt19937_64 rng(2);
  for (int at = 0; at <= kCycles; ++at) {
    packed_t<frame_record_t> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(rng());
    dut->start_i = 1;
    set_port(dut->record_i, unpack<frame_record_t>(words.data()));
    dut.tick();
    dut->start_i = 0;
    for (int i = 0; i < at; ++i) dut.tick();
    for (auto& word : words) word = static_cast<std::uint32_t>(rng());
    if (at % 2) dut.reset();
    expect_model(unpack<frame_record_t>(words.data()));
  }
}

}  // namespace
}  // namespace castray::tb
