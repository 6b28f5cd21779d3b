// SPDX-License-Identifier: Apache-2.0
// The materials' parameters out of a frame record: each field from its own bits.
#include <verilated.h>

#include "Vframe_paint.h"
#include "dut.hpp"
#include "shade/paint.hpp"

namespace castray::tb {
namespace {

paint_t rtl(const frame_record_t& record) {
  VerilatedContext context;
  Vframe_paint top(&context);
  set_port(top.record_i, record);
  top.eval();
  const auto got = get_port<paint_t>(top.paint_o);
  EXPECT_EQ(to_text(got), to_text(frame_paint(record)));
  return got;
}

TEST(FramePaint, ReadsEachField) {
  frame_record_t record;
  record.background = 0xff030201, record.colour_a = 0x00060504, record.colour_b = 0xaa090807;
  record.checker_scale = 0x2abcd;
  record.pixel_format = PixelBgra8;
  const paint_t p = rtl(record);
  EXPECT_EQ(pixel_word(p.background, false), 0xff030201u);
  EXPECT_EQ(pixel_word(p.colour_a, false), 0xff060504u);
  EXPECT_EQ(pixel_word(p.colour_b, true), 0xff070809u);
  EXPECT_EQ(p.checker_scale, 0x2abcdu);
  EXPECT_EQ(p.swap_rb, 1u);
}

TEST(FramePaint, OnlyOneFormatSwaps) {
  frame_record_t record;
  for (const std::uint64_t format : {0, 1, 2, 255}) {
    record.pixel_format = format;
    EXPECT_EQ(rtl(record).swap_rb, format == 1) << format;
  }
}

}  // namespace
}  // namespace castray::tb
