// SPDX-License-Identifier: Apache-2.0
// The pixel of a ray that hit nothing.
#include "shade/background.hpp"

#include "Vbackground.h"
#include "dut.hpp"
#include "stimulus.hpp"

namespace castray::tb {
namespace {

class Background : public testing::TestWithParam<Stalls> {
 protected:
  Dut<Vbackground> dut_;
};

paint_t painted(std::uint64_t r, std::uint64_t g, std::uint64_t b, bool swap) {
  paint_t p;
  p.background.r = r, p.background.g = g, p.background.b = b;
  p.colour_a.g = 77;
  p.swap_rb = swap;
  return p;
}

TEST_P(Background, MatchesModel) {
  Stimulus random(1);
  for (const bool swap : {false, true}) {
    const paint_t with = painted(1, 2, 3, swap);
    set_port(dut_->paint_i, with);
    std::vector<hit_t> misses;
    std::vector<shaded_t> want;
    for (int i = 0; i < 5000; ++i) {
      misses.push_back(random.hit());
      misses.back().found = 0;
      want.push_back(background(misses.back(), with));
    }
    expect_equal(run_stream<shaded_t>(dut_, misses, misses.size(), GetParam(), 5), want);
  }
}
INSTANTIATE_TEST_SUITE_P(Stalls, Background, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(Background, IsRgbaOrBgra) {
  for (const bool swap : {false, true}) {
    set_port(dut_->paint_i, painted(0x11, 0x22, 0x33, swap));
    const auto got = run_stream<shaded_t>(dut_, std::vector<hit_t>(1), 1);
    ASSERT_EQ(got.size(), 1u);
    EXPECT_EQ(got[0].colour, swap ? 0xff112233u : 0xff332211u);
  }
}

TEST_F(Background, TakesOneACycle) {
  const long before = dut_.cycles();
  run_stream<shaded_t>(dut_, std::vector<hit_t>(300), 300);
  EXPECT_LE(dut_.cycles() - before, 302);
}

}  // namespace
}  // namespace castray::tb
