// SPDX-License-Identifier: Apache-2.0
// From a ray's axes back to the scene's: the inverse of corner_delta's permutation.
#include "Vunpermute.h"
#include "dut.hpp"
#include "isect/corner_delta.hpp"

namespace castray::tb {
namespace {

span3_t rtl(const delta3_t& v, axis_t axis) {
  VerilatedContext context;
  Vunpermute top(&context);
  span3_t in;
  in.x = v.x, in.y = v.y, in.z = v.z;
  top.axis_i = axis;
  set_port(top.in_i, in);
  top.eval();
  return get_port<span3_t>(top.out_o);
}

TEST(Unpermute, BringsTheDominantComponentHome) {
  const std::int64_t want[4][3] = {{3, 1, 2}, {2, 3, 1}, {1, 2, 3}, {1, 2, 3}};  // 3 is the dominant one
  for (axis_t axis = 0; axis < 4; ++axis) {
    const span3_t got = rtl({1, 2, 3}, axis);
    EXPECT_EQ(got.x, want[axis][0]) << int(axis);
    EXPECT_EQ(got.y, want[axis][1]) << int(axis);
    EXPECT_EQ(got.z, want[axis][2]) << int(axis);
  }
}

TEST(Unpermute, UndoesThePermutationAtEveryExtreme) {
  const std::int64_t top = (std::int64_t{1} << (SpanW - 1)) - 1;
  for (const delta3_t& v : {delta3_t{top, -top - 1, 0}, delta3_t{0, top, -top - 1}, delta3_t{-1, 0, top}})
    for (axis_t axis = 0; axis < 3; ++axis) {
      const span3_t got = rtl(permute(v, axis), axis);
      EXPECT_TRUE(got.x == v.x && got.y == v.y && got.z == v.z) << to_text(got) << " axis " << int(axis);
    }
}

}  // namespace
}  // namespace castray::tb
