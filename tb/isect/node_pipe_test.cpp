// SPDX-License-Identifier: Apache-2.0
// Runs long.
// The node pipe: equal to its model, node for node; the limits of t, the order of children, every axis
// and the nodes that no image may hold, by hand.
#include "node_pipe_run.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kStep = 1 << TFrac;
constexpr std::int64_t kMargin = kBoxMarginT;

class NodePipe : public testing::TestWithParam<Stalls> {};
INSTANTIATE_TEST_SUITE_P(Stalls, NodePipe, testing::ValuesIn(kStallPatterns));

TEST_P(NodePipe, MatchesModel) {
  Rng rng(91);
  std::vector<NodeCase> cases(20000);
  for (NodeCase& c : cases) c = random_node_case(rng);
  int visits = 0;
  for (const visits_t& v : run(cases, GetParam())) visits += count(v);
  EXPECT_GT(visits, 8000);
}

// The box of the only child, from first to last steps along the ray, which runs through its middle.
NodeCase ahead(axis_t axis, bool neg, std::int64_t first, std::int64_t last) {
  NodeCase c = straight(axis, neg);
  const auto at = [&](std::int64_t t) { return static_cast<plane_t>(100 + (neg ? -t : t)); };
  const plane_t low = at(neg ? last : first), high = at(neg ? first : last);
  child_box_t box = whole_box();
  (axis == 0 ? box.x0 : axis == 1 ? box.y0 : box.z0) = low;
  (axis == 0 ? box.x1 : axis == 1 ? box.y1 : box.z1) = high;
  set_child(c, 0, box, leaf(5));
  return c;
}

TEST(NodePipe, DropsWhatLiesBeyondTheNearestHitAndItsMargin) {
  for (axis_t axis = 0; axis < 3; ++axis)
    for (const bool neg : {false, true}) {
      NodeCase c = ahead(axis, neg, 50, 60);
      const auto hits = [&](std::int64_t t) { return c.t = t, run_one(c).e0.target.kind == RefLeaf; };
      EXPECT_TRUE(hits(50 * kStep - kMargin)) << "axis " << axis << (neg ? " backwards" : "");
      EXPECT_TRUE(hits((50 - BoxMargin) * kStep));
      EXPECT_FALSE(hits((50 - BoxMargin) * kStep - 1));
      EXPECT_FALSE(hits(-TMax));
      EXPECT_TRUE(hits(TMax));
    }
}

TEST(NodePipe, DropsWhatEndsBeforeTminAndItsMargin) {
  for (axis_t axis = 0; axis < 3; ++axis)
    for (const bool neg : {false, true}) {
      NodeCase c = ahead(axis, neg, 50, 60);
      const auto hits = [&](std::int64_t tmin) { return c.ray.tmin = tmin, run_one(c).e0.target.kind == RefLeaf; };
      EXPECT_TRUE(hits(60 * kStep + kMargin)) << "axis " << axis << (neg ? " backwards" : "");
      EXPECT_TRUE(hits((61 + BoxMargin) * kStep - 1));
      EXPECT_FALSE(hits((61 + BoxMargin) * kStep));
      EXPECT_FALSE(hits(TMax));
      EXPECT_TRUE(hits(-TMax));
    }
}

// A zero component: a box is met up to its very planes, and no step beyond.
TEST(NodePipe, KnowsARayOnAPlane) {
  for (axis_t axis = 0; axis < 3; ++axis)
    for (const bool second : {false, true}) {
      const auto hits = [&](plane_t low, plane_t high) {
        NodeCase c = straight(axis);
        child_box_t box = whole_box();
        plane_t* const lows[] = {&box.x0, &box.y0, &box.z0};
        plane_t* const highs[] = {&box.x1, &box.y1, &box.z1};
        const axis_t across = (axis + (second ? 2 : 1)) % 3;
        *lows[across] = low, *highs[across] = high;
        set_child(c, 0, box, leaf(1));
        return run_one(c).e0.target.kind != RefNone;
      };
      EXPECT_TRUE(hits(100, 255)) << "axis " << axis;
      EXPECT_TRUE(hits(0, 100));
      EXPECT_TRUE(hits(100, 100));
      EXPECT_FALSE(hits(101, 255));
      EXPECT_FALSE(hits(0, 99));
    }
}

// A ray at 45 degrees, nearly, through or past a box's edge.
TEST(NodePipe, KnowsBothSignsOfAShear) {
  for (axis_t axis = 0; axis < 3; ++axis)
    for (const bool neg : {false, true})
      for (const shear_t s : {kOne - 1, 1 - kOne}) {
        const auto hits = [&](plane_t low, plane_t high) {   // of planes across the first axis, where z is 40 to 50
          NodeCase c = ahead(axis, neg, 40, 50);
          set_shear(c, s, 0);
          plane_t* const lows[] = {&c.node.box0.x0, &c.node.box0.y0, &c.node.box0.z0};
          plane_t* const highs[] = {&c.node.box0.x1, &c.node.box0.y1, &c.node.box0.z1};
          *lows[(axis + 1) % 3] = low, *highs[(axis + 1) % 3] = high;
          return run_one(c).e0.target.kind != RefNone;
        };
        const bool up = (s > 0) != neg;   // the ray is at 40 to 50 steps there, or at -40 to -50
        EXPECT_EQ(hits(150, 200), up);
        EXPECT_EQ(hits(152, 200), false);
        EXPECT_EQ(hits(110, 140), up);
        EXPECT_EQ(hits(110, 138), false);
        EXPECT_EQ(hits(0, 50), !up);
        EXPECT_EQ(hits(0, 48), false);
        EXPECT_EQ(hits(60, 90), !up);
        EXPECT_EQ(hits(62, 90), false);
      }
}

TEST(NodePipe, SortsNearToFarThenByNumber) {
  const plane_t at[4] = {180, 150, 180, 120};
  for (const bool neg : {false, true}) {
    NodeCase c = straight(2, neg);
    if (neg) c.ray.org.z += 150;
    for (int i = 0; i < 4; ++i) {
      child_box_t box = whole_box();
      box.z0 = at[i], box.z1 = static_cast<plane_t>(at[i] + 5);
      set_child(c, i, box, leaf(static_cast<std::uint64_t>(i)));
    }
    const visits_t v = run_one(c);
    const std::vector<std::uint64_t> want = neg ? std::vector<std::uint64_t>{0, 2, 1, 3} : std::vector<std::uint64_t>{3, 1, 0, 2};
    for (int i = 0; i < 4; ++i) EXPECT_EQ(entry(v, i).target.index, want[static_cast<std::size_t>(i)]) << "place " << i << " neg " << neg;
  }
  // All six orders of three, and of three of which two are alike.
  int order[3] = {0, 1, 2};
  do {
    for (const int third : {2, 1}) {
      NodeCase c = straight();
      for (int i = 0; i < 3; ++i) {
        child_box_t box = whole_box();
        box.z0 = static_cast<plane_t>(150 + 10 * std::min(order[i], third));
        set_child(c, i, box, inner(static_cast<std::uint64_t>(i + 1)));
      }
      const visits_t v = run_one(c);
      EXPECT_EQ(count(v), 3);
      EXPECT_EQ(order[v.e0.target.index - 1], 0);
      if (third == 2) EXPECT_EQ(order[v.e1.target.index - 1], 1);
      if (third == 1) EXPECT_LT(v.e1.target.index, v.e2.target.index);
    }
  } while (std::next_permutation(order, order + 3));
}

// The upper bits of the entry less the margin: at 2^20 steps, bit 6 of a dist_t.
TEST(NodePipe, SaysWhatAChildIsBeyond) {
  for (const bool neg : {false, true}) {
    const auto least = [&](std::int64_t steps) {
      NodeCase c = straight(1, neg);
      c.ray.org.z = static_cast<coord_t>(neg ? kGrid : 0);   // along y
      c.node.y = static_cast<coord_t>(neg ? kGrid - steps - 255 : steps);
      set_child(c, 0, whole_box(), leaf(1));
      return run_one(c).e0.least;
    };
    constexpr std::int64_t kDist = std::int64_t{1} << (CoordW - DistW);
    EXPECT_EQ(least(0), 0u);
    EXPECT_EQ(least(64 * kDist), 63u) << "neg " << neg;
    EXPECT_EQ(least(64 * kDist + kDist / 2 + 300), 64u);
    EXPECT_EQ(least(4000 * kDist + kDist / 2 + 300), 4000u);
  }
}

TEST(NodePipe, LeavesOutAChildThatIsNotThere) {
  for (int children = 0; children <= 4; ++children) {
    NodeCase c = straight();
    for (int i = 0; i < 4; ++i) set_child(c, i, whole_box(), i < children ? inner(9) : 0);
    EXPECT_EQ(count(run_one(c)), children);
  }
}

TEST(NodePipe, RefusesWhatIsNoNode) {
  NodeCase good = straight();
  for (int i = 0; i < 4; ++i) set_child(good, i, whole_box(), leaf(3));
  std::vector<NodeCase> cases;
  const auto bad = [&](auto change) {
    cases.push_back(good);
    change(cases.back().node);
    cases.push_back(good);
  };
  bad([](node_t& n) { n.exp_x = MaxPlaneExp + 1; });
  bad([](node_t& n) { n.exp_y = MaxPlaneExp + 1; });
  bad([](node_t& n) { n.exp_z = 31; });
  bad([](node_t& n) { n.ref0 = 0; });                                  // a child behind the end
  bad([](node_t& n) { n.ref1 = 0, n.ref2 = 0; });
  bad([](node_t& n) { n.ref3 = RefTile << LineW | 3; });
  bad([](node_t& n) { n.ref2 = 1; });                                  // no kind, but an index
  bad([](node_t& n) { n.ref1 |= std::uint64_t{1} << 24; });
  bad([](node_t& n) { n.ref0 |= std::uint64_t{1} << 31; });
  const auto results = run(cases);
  for (std::size_t i = 0; i < results.size(); ++i) {
    bool illegal = false;
    node_pipe(cases[i].ray, cases[i].node, cases[i].t, illegal);
    EXPECT_EQ(illegal, i % 2 == 0) << i;
    EXPECT_EQ(count(results[i]), i % 2 ? 4 : 0) << i;
  }
  good.node.exp_x = good.node.exp_y = good.node.exp_z = MaxPlaneExp;
  EXPECT_EQ(count(run_one(good)), 4);
}

TEST(NodePipe, ResetEmptiesThePipe) {
  Dut<Vnode_pipe> dut;
  NodeCase c = straight();
  set_child(c, 0, whole_box(), leaf(3));
  for (int i = 0; i < kLatency; ++i) {
    dut->in_valid_i = 1;
    offer(dut, c);
    dut.tick();
  }
  dut->in_valid_i = 0;
  dut.reset(1);
  for (int i = 0; i < 2 * kLatency; ++i) {
    dut.settle();
    EXPECT_FALSE(dut->out_valid_o);
    dut.tick();
  }
}

}  // namespace
}  // namespace castray::tb
