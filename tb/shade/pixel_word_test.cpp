// SPDX-License-Identifier: Apache-2.0
// The word of a pixel: which byte holds which colour, in either format.
#include "Vpixel_word.h"
#include "dut.hpp"
#include "shade/background.hpp"

namespace castray::tb {
namespace {

std::uint32_t rtl(std::uint64_t r, std::uint64_t g, std::uint64_t b, bool swap) {
  VerilatedContext context;
  Vpixel_word top(&context);
  rgb_t colour;
  colour.r = r, colour.g = g, colour.b = b;
  set_port(top.colour_i, colour);
  top.swap_rb_i = swap;
  top.eval();
  EXPECT_EQ(top.word_o, pixel_word(colour, swap));
  return top.word_o;
}

TEST(PixelWord, RedIsLowestInRgbaAndBlueInBgra) {
  EXPECT_EQ(rtl(0x11, 0x22, 0x33, false), 0xff332211u);
  EXPECT_EQ(rtl(0x11, 0x22, 0x33, true), 0xff112233u);
}

TEST(PixelWord, IsOpaqueAtEveryExtreme) {
  for (const bool swap : {false, true}) {
    EXPECT_EQ(rtl(0, 0, 0, swap), 0xff000000u);
    EXPECT_EQ(rtl(255, 255, 255, swap), 0xffffffffu);
    EXPECT_EQ(rtl(0, 255, 0, swap), 0xff00ff00u);
  }
}

}  // namespace
}  // namespace castray::tb
