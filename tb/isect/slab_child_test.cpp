// SPDX-License-Identifier: Apache-2.0
// A child's box on all three axes: equal to the model; each axis alone decides.
#include "Vslab_child.h"
#include "chain_run.hpp"
#include "node_cases.hpp"

namespace castray::tb {
namespace {

struct Child {
  child_box_t box;
  axis_t axis;
  slab_axis_t x, y;
};
span_ticks_t model(const Child& c) {
  const auto planes = [&](plane_t x, plane_t y, plane_t z) {
    return permute({static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), static_cast<std::int64_t>(z)}, c.axis);
  };
  const delta3_t q0 = planes(c.box.x0, c.box.y0, c.box.z0), q1 = planes(c.box.x1, c.box.y1, c.box.z1);
  return slab_child(c.x, c.y, {q0.x, q1.x, q0.y, q1.y, q0.z, q1.z});
}

// Two signed numbers or two others side by side on one port, x's in the lower bits.
std::uint64_t both(std::int64_t x, std::int64_t y, int bits) {
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  return (static_cast<std::uint64_t>(x) & mask) | (static_cast<std::uint64_t>(y) & mask) << bits;
}

class SlabChild : public testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<Child>& children, Stalls stalls = {}) {
    run_straight(
        dut_, 6, children.size(), stalls,
        [&](int stage, std::size_t i) {
          const Child& c = children[i];
          if (stage == 0) {
            set_port(dut_->box_i, c.box);
            set_port(dut_->axis_i, c.axis);
          }
          if (stage == 2) set_port(dut_->mant_i, both(c.x.mant, c.y.mant, 10)), set_port(dut_->more_i, both(c.x.mant + 1, c.y.mant + 1, 11));
          if (stage == 3) {
            set_port(dut_->minus_i, both(c.x.minus, c.y.minus, 1));
            set_port(dut_->low_i, both(c.x.low, c.y.low, slab_t_bits));
            set_port(dut_->high_i, both(c.x.high, c.y.high, slab_t_bits));
          }
          if (stage == 4) set_port(dut_->left_i, both(c.x.left, c.y.left, 4));
        },
        [&](unsigned load) { dut_->en_i = static_cast<unsigned char>(load); },
        [&](int stage, std::size_t i) {
          if (stage != 5) return;
          const span_ticks_t want = model(children[i]);
          ASSERT_TRUE(dut_->none_o == want.none && dut_->low_o == want.low && dut_->high_o == want.high)
              << castray::to_text(children[i].box) << " axis " << children[i].axis << "\nmodel " << want.none << " " << want.low << " "
              << want.high << "\nRTL   " << int{dut_->none_o} << " " << dut_->low_o << " " << dut_->high_o;
        });
  }
  // Of one child: none, low, high.
  std::array<std::int64_t, 3> of(const Child& c) {
    run({c});
    const span_ticks_t s = model(c);
    return {s.none, s.low, s.high};
  }

 private:
  Dut<Vslab_child> dut_;
};
INSTANTIATE_TEST_SUITE_P(Stalls, SlabChild, testing::ValuesIn(kStallPatterns));

TEST_P(SlabChild, MatchesModel) {
  Rng rng(131);
  std::vector<Child> children(20000);
  for (Child& c : children) {
    const auto axis = [&]() -> slab_axis_t {
      const std::int64_t reach = (std::int64_t{1} << rng.in(4, SubPlane + 10)) - 1;
      return {rng.chance(2), rng.in(0, 1023), rng.in(-reach, reach), rng.in(-reach, reach), static_cast<int>(rng.in(0, 15) * rng.chance(2))};
    };
    c = {any_box(rng), static_cast<axis_t>(rng.in(0, 2)), axis(), axis()};
  }
  run(children, GetParam());
}

// Everywhere but on the dominant axis, then but on one of the two others.
TEST_F(SlabChild, TakesTheLastEntryAndTheFirstExit) {
  const slab_axis_t everywhere{false, 0, -1, kTickMax + 1, 0};
  const child_box_t box = {.x0 = 10, .y0 = 20, .z0 = 30, .x1 = 200, .y1 = 210, .z1 = 220};
  const std::int64_t tick = 1 << SubPlane;
  using Result = std::array<std::int64_t, 3>;
  EXPECT_EQ(of({box, 0, everywhere, everywhere}), (Result{0, 10 * tick, 200 * tick}));
  EXPECT_EQ(of({box, 1, everywhere, everywhere}), (Result{0, 20 * tick, 210 * tick}));
  EXPECT_EQ(of({box, 2, everywhere, everywhere}), (Result{0, 30 * tick, 220 * tick}));
  const slab_axis_t some{false, 0, 40 * tick, 80 * tick, 0};
  const std::int64_t most = (200 >> (9 - SubPlane)) + 1;   // of mant 0 and either high plane
  EXPECT_EQ(of({box, 2, some, everywhere}), (Result{0, 40 * tick, 80 * tick + most}));
  EXPECT_EQ(of({box, 2, everywhere, some}), (Result{0, 40 * tick, 80 * tick + most}));
  const slab_axis_t before{false, 0, -300, -200, 0};
  EXPECT_EQ(of({box, 2, before, everywhere})[0], 1);
  EXPECT_EQ(of({box, 2, everywhere, before})[0], 1);
}

}  // namespace
}  // namespace castray::tb
