// SPDX-License-Identifier: Apache-2.0
// A position seen from the ray's origin: which axis goes where, and every extreme.
#include "Vcorner_delta.h"
#include "dut.hpp"
#include "prim_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

class CornerDelta : public testing::Test {
 protected:
  // The unit's answer, which must be the model's.
  delta3_t at(const point_t& point, const point_t& org, axis_t axis) {
    set_port(top_.point_i, point);
    set_port(top_.org_i, permuted(org, axis));
    top_.axis_i = axis;
    top_.eval();
    const delta3_t got{get_signed(top_.x_o, delta_t_bits), get_signed(top_.y_o, delta_t_bits), get_signed(top_.z_o, delta_t_bits)};
    const delta3_t want = corner_delta(point, permuted(org, axis), axis);
    EXPECT_TRUE(got.x == want.x && got.y == want.y && got.z == want.z)
        << to_text(point) << " from " << to_text(org) << " axis " << int(axis) << ": " << got.x << " " << got.y << " " << got.z;
    return got;
  }

 private:
  VerilatedContext context_;
  Vcorner_delta top_{&context_};
};

point_t point_of(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  point_t p;
  p.x = x, p.y = y, p.z = z;
  return p;
}

TEST_F(CornerDelta, BringsTheDominantAxisLast) {
  const point_t org = point_of(100, 200, 300), point = point_of(101, 202, 303);  // 1, 2, 3 from it
  const std::int64_t want[4][3] = {{2, 3, 1}, {3, 1, 2}, {1, 2, 3}, {1, 2, 3}};
  for (axis_t axis = 0; axis < 4; ++axis) {
    const delta3_t d = at(point, org, axis);
    EXPECT_EQ(d.x, want[axis][0]) << int(axis);
    EXPECT_EQ(d.y, want[axis][1]) << int(axis);
    EXPECT_EQ(d.z, want[axis][2]) << int(axis);
  }
}

TEST_F(CornerDelta, IsExactFromEndToEndOfTheGrid) {
  const std::uint64_t ends[4] = {0, 1, (1u << CoordW) - 1, 1u << (CoordW - 1)};
  for (const std::uint64_t p : ends)
    for (const std::uint64_t o : ends)
      for (int k = 0; k < 3; ++k) {  // along one axis; the others stay in place
        const point_t org = point_of(k == 0 ? o : 5, k == 1 ? o : 5, k == 2 ? o : 5);
        const point_t point = point_of(k == 0 ? p : 5, k == 1 ? p : 5, k == 2 ? p : 5);
        for (axis_t axis = 0; axis < 3; ++axis) {
          const delta3_t d = unpermute(at(point, org, axis), axis);
          const std::int64_t along = static_cast<std::int64_t>(p) - static_cast<std::int64_t>(o);
          EXPECT_EQ(d.x, k == 0 ? along : 0);
          EXPECT_EQ(d.y, k == 1 ? along : 0);
          EXPECT_EQ(d.z, k == 2 ? along : 0);
        }
      }
}

TEST_F(CornerDelta, MatchesModel) {
  Rng rng(1);
  for (int i = 0; i < 100000; ++i) at(rng.point(), rng.point(), static_cast<axis_t>(rng.in(0, 3)));
}

}  // namespace
}  // namespace castray::tb
