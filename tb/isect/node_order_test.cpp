// SPDX-License-Identifier: Apache-2.0
// The order of a node's children, and the least t of each: equal to the model; every order of four, with
// every set of them visited; each reason not to visit; the ends of a dist_t.
#include "Vnode_order.h"
#include "chain_run.hpp"
#include "node_cases.hpp"
#include "signed_port.hpp"
#include "visits_read.hpp"

namespace castray::tb {
namespace {

struct Order {
  std::array<child_t, 4> children;
  span_ticks_t limits{false, 0, kTickMax};
  std::int64_t dz = 0;
  int ez = 0;
  bool neg = false;
};
visits_t model(const Order& o) { return node_order(o.children, o.limits, o.dz, o.ez, o.neg); }

class NodeOrder : public testing::TestWithParam<Stalls> {
 protected:
  void run(const std::vector<Order>& orders, Stalls stalls = {}) {
    run_straight(
        dut_, 2, orders.size(), stalls,
        [&](int stage, std::size_t i) {
          const Order& o = orders[i];
          if (stage == 0) {
            dut_->neg_i = o.neg;
            set_signed(dut_->dz_i, o.dz, delta_t_bits);
            dut_->ez_i = static_cast<unsigned char>(o.ez);
          }
          if (stage == 1) {
            std::uint64_t low = 0, high = 0;
            dut_->exists_i = dut_->none_i = 0;
            for (int k = 0; k < 4; ++k) {
              const child_t& c = o.children[static_cast<std::size_t>(k)];
              dut_->exists_i |= static_cast<unsigned char>(c.exists << k);
              dut_->none_i |= static_cast<unsigned char>(c.inside.none << k);
              low |= static_cast<std::uint64_t>(c.inside.low) << (k * tick_t_bits);
              high |= static_cast<std::uint64_t>(c.inside.high) << (k * tick_t_bits);
            }
            set_port(dut_->low_i, low);
            set_port(dut_->high_i, high);
            dut_->limits_none_i = o.limits.none;
            set_port(dut_->first_i, o.limits.low);
            set_port(dut_->last_i, o.limits.high);
          }
        },
        [&](unsigned load) { dut_->en_i = static_cast<unsigned char>(load); },
        [&](int stage, std::size_t i) {
          if (stage != 1) return;
          std::uint32_t words[4] = {};
          for (std::size_t k = 0; k < 4; ++k)
            set_bits(words, static_cast<int>(k) * ref_t::kBits, ref_t::kBits, pack(orders[i].children[k].target)[0]);
          for (int k = 0; k < 3; ++k) dut_->target_i[k] = words[k];
          dut_.settle();
          const visits_t want = model(orders[i]), got = as_read(get_port<visits_t>(dut_->out_o));
          ASSERT_TRUE(want == got) << "item " << i << "\nmodel " << castray::to_text(want) << "\nRTL   " << castray::to_text(got);
        });
  }

 private:
  Dut<Vnode_order> dut_;
};
INSTANTIATE_TEST_SUITE_P(Stalls, NodeOrder, testing::ValuesIn(kStallPatterns));

TEST_P(NodeOrder, MatchesModel) {
  Rng rng(141);
  std::vector<Order> orders(20000);
  for (Order& o : orders) {
    for (child_t& c : o.children) {
      c.exists = !rng.chance(6);
      const std::int64_t a = rng.in(0, rng.chance(3) ? 3 : kTickMax), b = rng.in(0, rng.chance(3) ? 3 : kTickMax);
      c.inside = {rng.chance(8), rng.chance(8) ? a : std::min(a, b), rng.chance(8) ? b : std::max(a, b)};
      c.target.kind = static_cast<std::uint64_t>(rng.in(RefNode, RefLeaf));
      c.target.index = static_cast<std::uint64_t>(rng.in(0, (1 << LineW) - 1));
    }
    o.limits = {rng.chance(20), rng.chance(2) ? 0 : rng.in(0, kTickMax), rng.chance(2) ? kTickMax : rng.in(0, kTickMax)};
    o.dz = rng.in(-kGrid, kGrid) >> rng.in(0, CoordW), o.ez = static_cast<int>(rng.in(0, MaxPlaneExp)), o.neg = rng.chance(2);
  }
  run(orders, GetParam());
}

Order four(const int (&place)[4], bool neg) {
  Order o;
  o.neg = neg;
  for (std::size_t i = 0; i < 4; ++i) {
    o.children[i].exists = true;
    o.children[i].inside = neg ? span_ticks_t{false, 0, kTickMax - 10 * place[i]} : span_ticks_t{false, 10 * place[i], kTickMax};
    o.children[i].target = {.index = i, .kind = RefLeaf};
  }
  return o;
}

// 4^4 places, ties among them, times 16 sets of children, in both directions.
TEST_F(NodeOrder, SortsEveryOrderOfEverySet) {
  std::vector<Order> orders;
  for (int code = 0; code < 256; ++code)
    for (unsigned set = 0; set < 16; ++set)
      for (const bool neg : {false, true}) {
        const int place[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6};
        Order o = four(place, neg);
        std::vector<std::pair<int, std::size_t>> want;
        for (std::size_t i = 0; i < 4; ++i) {
          o.children[i].exists = set >> i & 1;
          if (o.children[i].exists) want.emplace_back(place[i], i);
        }
        std::sort(want.begin(), want.end());
        const visits_t v = model(o);
        for (std::size_t k = 0; k < 4; ++k) {
          const entry_t& e = entry(v, static_cast<int>(k));
          ASSERT_EQ(e.target.kind, k < want.size() ? RefLeaf : RefNone);
          if (k < want.size()) ASSERT_EQ(e.target.index, want[k].second);
        }
        orders.push_back(o);
      }
  run(orders);
}

TEST_F(NodeOrder, VisitsOnlyWhatMeetsTheLimits) {
  const auto visits = [&](span_ticks_t child, span_ticks_t limits) {
    Order o = four({0, 1, 2, 3}, false);
    for (child_t& c : o.children) c.exists = false;
    o.children[2].exists = true;
    o.children[2].inside = child;
    o.limits = limits;
    run({o});
    return model(o).e0.target.kind == RefLeaf;
  };
  EXPECT_TRUE(visits({false, 5, 9}, {false, 0, 100}));
  EXPECT_TRUE(visits({false, 5, 5}, {false, 5, 5}));
  EXPECT_TRUE(visits({false, 5, 9}, {false, 9, 100}));
  EXPECT_FALSE(visits({false, 5, 9}, {false, 10, 100}));
  EXPECT_TRUE(visits({false, 5, 9}, {false, 0, 5}));
  EXPECT_FALSE(visits({false, 5, 9}, {false, 0, 4}));
  EXPECT_FALSE(visits({false, 6, 5}, {false, 0, 100}));
  EXPECT_FALSE(visits({true, 5, 9}, {false, 0, 100}));
  EXPECT_FALSE(visits({false, 5, 9}, {true, 0, 100}));
}

TEST_F(NodeOrder, CutsTheLeastToItsFormat) {
  const auto least = [&](std::int64_t dz, int ez, bool neg, std::int64_t tick) {
    Order o = four({0, 0, 0, 0}, neg);
    o.dz = dz, o.ez = ez;
    for (child_t& c : o.children) c.inside = {false, tick, tick};
    run({o});
    return model(o).e3.least;
  };
  constexpr std::int64_t kDist = std::int64_t{1} << (CoordW - DistW), kEnd = (std::int64_t{1} << CoordW) - 1;
  constexpr std::uint64_t kLast = (1u << DistW) - 1;
  EXPECT_EQ(least(5 * kDist + BoxMargin, 0, false, 0), 5u);
  EXPECT_EQ(least(5 * kDist + BoxMargin - 1, 0, false, 0), 4u);
  EXPECT_EQ(least(-6 * kDist, 0, true, 0), 5u);
  EXPECT_EQ(least(-5 * kDist, 0, true, 0), 4u);
  EXPECT_EQ(least(0, 0, false, 0), 0u);
  EXPECT_EQ(least(0, 0, true, 0), 0u);
  EXPECT_EQ(least(-kEnd, 0, false, kTickMax), 0u);
  EXPECT_EQ(least(kEnd, 0, true, kTickMax), 0u);
  EXPECT_EQ(least(kEnd, 0, false, kTickMax), kLast);
  EXPECT_EQ(least(kEnd, MaxPlaneExp, false, kTickMax), kLast);
  EXPECT_EQ(least(-kEnd, 0, true, 0), kLast);
  EXPECT_EQ(least(0, 14, false, 1 << SubPlane), 0u) << "a plane away, less the margin";
  EXPECT_EQ(least(BoxMargin, 14, false, 1 << SubPlane), 1u);
}

}  // namespace
}  // namespace castray::tb
