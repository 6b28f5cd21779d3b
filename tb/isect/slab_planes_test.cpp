// SPDX-License-Identifier: Apache-2.0
// A child's planes across one axis: equal to the model; every shift, both ends of a tick's format.
#include "Vslab_planes.h"
#include "chain_run.hpp"
#include "node_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

struct Planes {
  slab_axis_t axis;
  std::int64_t q0, q1;
};

class SlabPlanes : public testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<Planes>& planes, Stalls stalls = {}) {
    run_straight(
        dut_, 4, planes.size(), stalls,
        [&](int stage, std::size_t i) {
          const Planes& p = planes[i];
          if (stage == 0) dut_->q0_i = static_cast<unsigned char>(p.q0), dut_->q1_i = static_cast<unsigned char>(p.q1);
          if (stage == 1) dut_->mant_i = static_cast<unsigned short>(p.axis.mant), dut_->more_i = static_cast<unsigned short>(p.axis.mant + 1);
          if (stage == 2) {
            dut_->minus_i = p.axis.minus;
            set_signed(dut_->low_i, p.axis.low, slab_t_bits);
            set_signed(dut_->high_i, p.axis.high, slab_t_bits);
          }
          if (stage == 3) dut_->left_i = static_cast<unsigned char>(p.axis.left);
        },
        [&](unsigned load) { dut_->en_i = static_cast<unsigned char>(load); },
        [&](int stage, std::size_t i) {
          if (stage != 3) return;
          const Planes& p = planes[i];
          const span_ticks_t want = slab_planes(p.axis, p.q0, p.q1);
          ASSERT_TRUE(dut_->none_o == want.none && dut_->low_o == want.low && dut_->high_o == want.high)
              << "minus " << p.axis.minus << " left " << p.axis.left << " mant " << p.axis.mant << " from " << p.axis.low << " to "
              << p.axis.high << " planes " << p.q0 << " " << p.q1 << "\nmodel " << want.none << " " << want.low << " " << want.high
              << "\nRTL   " << int{dut_->none_o} << " " << dut_->low_o << " " << dut_->high_o;
        });
  }

 private:
  Dut<Vslab_planes> dut_;
};
INSTANTIATE_TEST_SUITE_P(Stalls, SlabPlanes, testing::ValuesIn(kStallPatterns));

constexpr std::int64_t kEnd = std::int64_t{1} << (SubPlane + 11);

TEST_P(SlabPlanes, MatchesModel) {
  Rng rng(111);
  std::vector<Planes> planes(20000);
  for (Planes& p : planes) {
    const std::int64_t reach = (std::int64_t{1} << rng.in(1, SubPlane + 11)) - 1;
    p.axis = {rng.chance(2), rng.chance(8) ? 1023 : rng.in(0, 1023), rng.in(-reach, reach), rng.in(-reach, reach), static_cast<int>(rng.in(0, 15))};
    p.q0 = rng.in(0, 255), p.q1 = rng.in(0, 255);
  }
  run(planes, GetParam());
}

// Positions of a few ticks, of the largest tick, and just beyond it, at every shift.
TEST_F(SlabPlanes, CutsToATick) {
  std::vector<Planes> planes;
  for (int left = 0; left < 16; ++left)
    for (const std::int64_t low : {-kEnd, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, kTickMax >> left, (kTickMax >> left) + 1, kEnd - 1})
      for (const bool minus : {false, true}) planes.push_back({{minus, 0, low, low, left}, 0, 0});
  run(planes);
  const auto at = [](std::int64_t x, int left) { return to_ticks(x, left); };
  EXPECT_EQ(at(kTickMax, 0), kTickMax);
  EXPECT_EQ(at(kTickMax + 1, 0), kTickMax);
  EXPECT_EQ(at(3, 4), 48);
  EXPECT_EQ(at(1, 15), kTickMax);
  EXPECT_EQ(at(0, 15), 0);
  EXPECT_EQ(at(-1, 0), 0);
}

// Least is rounded down, most is at least the product with mant + 1, whatever the signs.
TEST_F(SlabPlanes, RoundsOutwards) {
  std::vector<Planes> planes;
  for (const bool minus : {false, true})
    for (const std::int64_t q : {0, 1, 2, 127, 128, 254, 255})
      for (const std::int64_t mant : {0, 1, 511, 512, 513, 1022, 1023}) {
        const slab_axis_t axis{minus, mant, kTickMax / 2, kTickMax / 2, 0};
        planes.push_back({axis, q, q});
        const span_ticks_t s = slab_planes(axis, q, q);
        const std::int64_t low = s.low - kTickMax / 2, high = s.high - kTickMax / 2, scale = 1 << (9 - SubPlane);
        if (s.low == 0 || s.high == kTickMax || s.low == kTickMax) continue;
        EXPECT_LE(low * scale, minus ? -q * (mant + 1) : q * mant) << q << " " << mant;
        EXPECT_GE(high * scale, minus ? -q * mant : q * (mant + 1)) << q << " " << mant;
        EXPECT_LE(high - low, 3 + q / scale);
      }
  run(planes);
}

}  // namespace
}  // namespace castray::tb
