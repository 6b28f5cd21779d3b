// SPDX-License-Identifier: Apache-2.0
// What tmin and t leave of a ray inside a node: equal to the model; the margin, both directions, the
// ends of the formats.
#include "Vslab_limits.h"
#include "chain_run.hpp"
#include "node_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

struct Limits {
  t_t tmin, t;
  bool neg;
  std::int64_t dz;
  int ez;
};

class SlabLimits : public testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<Limits>& limits, Stalls stalls = {}) {
    run_straight(
        dut_, 6, limits.size(), stalls,
        [&](int stage, std::size_t i) {
          if (stage != 0) return;
          const Limits& l = limits[i];
          set_signed(dut_->tmin_i, l.tmin, t_t_bits);
          set_signed(dut_->t_i, l.t, t_t_bits);
          dut_->neg_i = l.neg;
          set_signed(dut_->dz_i, l.dz, delta_t_bits);
          dut_->ez_i = static_cast<unsigned char>(l.ez);
        },
        [&](unsigned load) { dut_->en_i = static_cast<unsigned char>(load); },
        [&](int stage, std::size_t i) {
          if (stage != 5) return;
          const Limits& l = limits[i];
          const span_ticks_t want = slab_limits(l.tmin, l.t, l.neg, l.dz, l.ez);
          ASSERT_TRUE(dut_->none_o == want.none && dut_->first_o == want.low && dut_->last_o == want.high)
              << "tmin " << l.tmin << " t " << l.t << " neg " << l.neg << " dz " << l.dz << " ez " << l.ez << "\nmodel " << want.none
              << " " << want.low << " " << want.high << "\nRTL   " << int{dut_->none_o} << " " << dut_->first_o << " " << dut_->last_o;
          last = want;
        });
  }
  void expect(const Limits& l, bool none, std::int64_t first, std::int64_t end) {
    run({l});
    EXPECT_EQ(last.none, none);
    EXPECT_EQ(last.low, first);
    EXPECT_EQ(last.high, end);
  }
  span_ticks_t last;

 private:
  Dut<Vslab_limits> dut_;
};
INSTANTIATE_TEST_SUITE_P(Stalls, SlabLimits, testing::ValuesIn(kStallPatterns));

TEST_P(SlabLimits, MatchesModel) {
  Rng rng(121);
  std::vector<Limits> limits(20000);
  for (Limits& l : limits) {
    l.dz = rng.in(-kGrid, kGrid) >> rng.in(0, CoordW), l.ez = static_cast<int>(rng.in(0, rng.chance(9) ? 31 : MaxPlaneExp)), l.neg = rng.chance(2);
    const auto t = [&] {
      const std::int64_t inside = ((l.neg ? -l.dz : l.dz) + rng.in(-300, 300) * (std::int64_t{1} << l.ez)) * (1 << TFrac) + rng.in(0, 15);
      return rng.chance(8) ? (rng.chance(2) ? TMax : -TMax - 1) : rng.chance(3) ? rng.in(-TMax, TMax) : std::clamp(inside, -TMax, TMax);
    };
    l.tmin = t(), l.t = t();
  }
  run(limits, GetParam());
}

// A node 1000 steps away, a step between its planes; t and tmin in whole steps around it.
TEST_F(SlabLimits, MovesThemApartByTheMargin) {
  constexpr std::int64_t kStep = 1 << TFrac, kTick = 1 << SubPlane;
  expect({1020 * kStep, 1030 * kStep, false, 1000, 0}, false, (20 - BoxMargin) * kTick, (30 + BoxMargin) * kTick);
  expect({1020 * kStep, 1030 * kStep, true, -1050, 0}, false, (20 - BoxMargin) * kTick, (30 + BoxMargin) * kTick);
  expect({1020 * kStep + 15, 1030 * kStep + 15, false, 1000, 0}, false, (20 - BoxMargin) * kTick, (30 + BoxMargin) * kTick);
  expect({1020 * kStep, 1030 * kStep + 15, false, 1000, 4}, false, ((20 - BoxMargin) * kTick) >> 4, ((30 + BoxMargin) * kTick) >> 4);
}

TEST_F(SlabLimits, CutsToTheNode) {
  constexpr std::int64_t kStep = 1 << TFrac;
  expect({0, TMax, false, 1000, 0}, false, 0, kTickMax);
  expect({0, (1000 - BoxMargin) * kStep, false, 1000, 0}, false, 0, 0);
  expect({0, (1000 - BoxMargin) * kStep - 1, false, 1000, 0}, true, 0, 0);
  expect({2000 * kStep, TMax, false, 1000, 0}, false, kTickMax, kTickMax);
  const std::int64_t end = (std::int64_t{1} << CoordW) - 1;
  expect({-TMax - 1, TMax, false, end, 0}, false, 0, (BoxMargin << SubPlane));
  expect({-TMax - 1, TMax, true, end, 0}, false, 0, (BoxMargin + 1) << SubPlane);
  expect({TMax, TMax, true, end, 0}, true, 0, 0);
  expect({-TMax - 1, -TMax - 1, false, -end, 0}, false, 0, (BoxMargin - 1) << SubPlane);
}

}  // namespace
}  // namespace castray::tb
