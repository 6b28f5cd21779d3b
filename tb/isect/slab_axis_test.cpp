// SPDX-License-Identifier: Apache-2.0
// A node's planes across one axis: equal to the model; the model's bounds enclose every plane's
// crossing, exactly; ends of the formats.
#include "Vslab_axis.h"
#include "chain_run.hpp"
#include "node_cases.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

struct Axis {
  recip_t recip;
  std::int64_t d, dz;
  int e, ez;
};
slab_axis_t model(const Axis& a) { return slab_axis(a.recip, a.d, a.e, a.dz, a.ez); }

Axis random_axis(Rng& rng) {
  const auto delta = [&] {
    const std::int64_t reach = (std::int64_t{1} << rng.in(0, CoordW)) - 1;
    return rng.chance(8) ? (rng.chance(2) ? reach : -reach) : rng.in(-reach, reach);
  };
  return {recip_of(slab_shear(rng)), delta(), delta(), static_cast<int>(rng.in(0, MaxPlaneExp)), static_cast<int>(rng.in(0, MaxPlaneExp))};
}

class SlabAxis : public testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<Axis>& axes, Stalls stalls = {}) {
    run_straight(
        dut_, 4, axes.size(), stalls,
        [&](int stage, std::size_t i) {
          if (stage != 0) return;
          set_port(dut_->recip_i, axes[i].recip);
          set_signed(dut_->d_i, axes[i].d, delta_t_bits);
          set_signed(dut_->dz_i, axes[i].dz, delta_t_bits);
          dut_->e_i = static_cast<unsigned char>(axes[i].e);
          dut_->ez_i = static_cast<unsigned char>(axes[i].ez);
        },
        [&](unsigned load) { dut_->en_i = static_cast<unsigned char>(load); },
        [&](int stage, std::size_t i) {
          const slab_axis_t want = model(axes[i]);
          const auto text = [&] { return castray::to_text(axes[i].recip) + " d " + std::to_string(axes[i].d) + " dz " + std::to_string(axes[i].dz) +
                                         " e " + std::to_string(axes[i].e) + " ez " + std::to_string(axes[i].ez); };
          if (stage == 1) ASSERT_TRUE(dut_->mant_o == want.mant && dut_->more_o == want.mant + 1) << text();
          if (stage == 2) {
            ASSERT_EQ(dut_->minus_o, want.minus) << text();
            ASSERT_EQ(get_signed(dut_->low_o, slab_t_bits), want.low) << text();
            ASSERT_EQ(get_signed(dut_->high_o, slab_t_bits), want.high) << text();
          }
          if (stage == 3) ASSERT_EQ(dut_->left_o, want.left) << text();
        });
  }

 private:
  Dut<Vslab_axis> dut_;
};
INSTANTIATE_TEST_SUITE_P(Stalls, SlabAxis, testing::ValuesIn(kStallPatterns));

TEST_P(SlabAxis, MatchesModel) {
  Rng rng(101);
  std::vector<Axis> axes(20000);
  for (Axis& a : axes) a = random_axis(rng);
  run(axes, GetParam());
}

TEST_F(SlabAxis, ReachesEveryExtreme) {
  const std::int64_t end = (std::int64_t{1} << CoordW) - 1;
  std::vector<Axis> axes;
  for (const std::int64_t d : {end, -end, std::int64_t{0}, std::int64_t{-1}, std::int64_t{1}})
    for (const std::int64_t dz : {end, -end, std::int64_t{0}})
      for (const shear_t s : {kOne - 1, 1 - kOne, std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, kOne / 2, -kOne / 2})
        for (const int e : {0, 1, static_cast<int>(MaxPlaneExp)})
          for (const int ez : {0, 1, static_cast<int>(MaxPlaneExp)}) axes.push_back({recip_of(s), d, dz, e, ez});
  run(axes);
}

// The position of plane q, ((d + q 2^e) / S - dz) in ticks of the axis, lies between the bounds, unless
// both say that it is far outside the node: then it is, on the same side.
TEST_F(SlabAxis, ModelEnclosesEveryPlane) {
  Rng rng(102);
  long near = 0;
  for (int i = 0; i < 300000; ++i) {
    const shear_t s = slab_shear(rng);
    Axis a = random_axis(rng);
    a.recip = recip_of(s);
    if (s == 0) continue;
    if (rng.chance(2)) a.d = ((s * a.dz) >> ShearFrac) + rng.in(-300, 300) * (std::int64_t{1} << a.e), a.d = std::clamp(a.d, -kGrid, kGrid);
    const slab_axis_t m = model(a);
    const std::int64_t q = rng.in(0, 255);
    const int tick = std::max(a.e + static_cast<int>(a.recip.exp), a.ez) - static_cast<int>(SubPlane);  // 2^tick steps
    const std::int64_t least = (q * m.mant) >> (9 - SubPlane), most = ((q * (m.mant + 1)) >> (9 - SubPlane)) + 1;
    const std::int64_t low = m.low + (m.minus ? -most : least), high = m.high + (m.minus ? -least : most);
    // exact = num / den ticks, both times 2^SubPlane
    const std::int64_t k = std::abs(s);
    const int128 num = (((int128{a.d} + (int128{q} << a.e)) * (s < 0 ? -1 : 1) << ShearFrac) - int128{a.dz} * k) << SubPlane;
    const int128 den = int128{k} << (tick + static_cast<int>(SubPlane));
    constexpr std::int64_t kEnd = std::int64_t{1} << (SubPlane + 10), kWindow = kTickMax;
    const bool from = low * den <= num, to = num <= high * den;
    if (low < 0 && high < 0) {
      ASSERT_TRUE(to) << i;                       // it does end before the node
    } else if (low > kWindow) {
      ASSERT_TRUE(from) << i;                     // it does begin behind the node
    } else {
      if (low >= 0) ASSERT_TRUE(from) << castray::to_text(a.recip) << " q " << q << " low " << low;
      if (high <= kWindow) ASSERT_TRUE(to) << castray::to_text(a.recip) << " q " << q << " high " << high;
      near += low > -kEnd && high < kEnd;
    }
  }
  EXPECT_GT(near, 50000);
}

}  // namespace
}  // namespace castray::tb
