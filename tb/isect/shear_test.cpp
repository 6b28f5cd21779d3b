// SPDX-License-Identifier: Apache-2.0
// A corner moved along the ray: halves go up, the ends of the grid fit, stages keep what they hold.
#include "Vshear.h"
#include "chain_run.hpp"
#include "prim_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

struct Corner {
  delta3_t delta;
  shear_t sx, sy;
};

class Shear : public testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<Corner>& corners, Stalls stalls = {}) {
    run_chain(
        dut_, 3, corners.size(), stalls,
        [&](std::size_t i) {
          const Corner& c = corners[i];
          set_signed(dut_->not_x_i, ~c.delta.x, delta_t_bits);
          set_signed(dut_->not_y_i, ~c.delta.y, delta_t_bits);
          set_signed(dut_->back_z_i, -c.delta.z, delta_t_bits);
          set_signed(dut_->sx_i, c.sx, shear_t_bits);
          set_signed(dut_->sy_i, c.sy, shear_t_bits);
        },
        [&](unsigned load) { dut_->en_i = load; },
        [&](std::size_t i) {
          const Corner& c = corners[i];
          last_x = get_signed(dut_->x_o, sheared_t_bits);
          last_y = get_signed(dut_->y_o, sheared_t_bits);
          ASSERT_EQ(last_x, shear(c.delta.x, c.delta.z, c.sx)) << "x of " << c.delta.x << ", " << c.delta.z << " by " << c.sx;
          ASSERT_EQ(last_y, shear(c.delta.y, c.delta.z, c.sy)) << "y of " << c.delta.y << ", " << c.delta.z << " by " << c.sy;
        });
  }
  // X and Y of one corner.
  void expect(const Corner& corner, std::int64_t x, std::int64_t y) {
    run({corner});
    EXPECT_EQ(last_x, x);
    EXPECT_EQ(last_y, y);
  }
  std::int64_t last_x = 0, last_y = 0;

 private:
  Dut<Vshear> dut_;
};

TEST_F(Shear, RoundsHalvesUp) {
  expect({{1, -1, 0}, 0, 0}, 1, 0);
  expect({{3, -3, 0}, 0, 0}, 2, -1);
  expect({{0, 0, 1}, kOne / 2, -kOne / 2}, 0, 0);  // -1/4, 1/4
  expect({{0, 0, 2}, kOne / 2, -kOne / 2}, 0, 1);  // -1/2, 1/2
  expect({{0, 0, -2}, kOne / 2, -kOne / 2}, 1, 0);
  expect({{1, 1, 2}, 1, -1}, 0, 1);  // a half, and the smallest shear under or over it
  expect({{-1, -1, 2}, 1, -1}, -1, 0);
}

TEST_F(Shear, KeepsXAndYApart) {
  expect({{20, 40, 100}, kOne / 4, -kOne / 8}, -2, 26);  // (20 - 25) / 2, (40 + 12.5) / 2
  expect({{40, 20, 100}, -kOne / 8, kOne / 4}, 26, -2);
}

TEST_F(Shear, ReachesEveryExtreme) {
  const std::int64_t end = (std::int64_t{1} << CoordW) - 1;
  std::vector<Corner> corners;
  for (const std::int64_t x : {end, -end, std::int64_t{0}})
    for (const std::int64_t z : {end, -end, std::int64_t{1}, std::int64_t{-1}})
      for (const shear_t s : {kOne - 1, 1 - kOne, std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}})
        for (const shear_t t : {kOne - 1, 1 - kOne}) corners.push_back({{x, -x, z}, s, t});
  run(corners);
  expect({{end, -end, -end}, kOne - 1, 1 - kOne}, end, -end);  // just short of a unit more
}

TEST_P(Shear, MatchesModel) {
  Rng rng(2);
  std::vector<Corner> corners(20000);
  for (Corner& c : corners) {
    const std::int64_t reach = (std::int64_t{1} << rng.in(1, CoordW)) - 1;
    c.delta = {rng.in(-reach, reach), rng.in(-reach, reach), rng.in(-reach, reach)};
    c.sx = rng.shear(), c.sy = rng.shear();
  }
  run(corners, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Stalls, Shear, testing::ValuesIn(kStallPatterns), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace castray::tb
