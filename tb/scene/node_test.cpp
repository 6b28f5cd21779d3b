// SPDX-License-Identifier: Apache-2.0
// Planes of 8 bits: outward, on the finest grid that covers the children; the padding of primitives.
#include "scene/node.hpp"

#include <gtest/gtest.h>

#include <random>

namespace castray {
namespace {

Box box(Box::Corner low, Box::Corner high) {
  Box made;
  made.add(low);
  made.add(high);
  return made;
}

NodeChild leaf(const Box& box, std::uint64_t index = 0) { return {box, ref_word(RefLeaf, index)}; }

node_t node_of_width(std::int64_t width) { return make_node(std::vector{leaf(box({1000, 0, 0}, {1000 + width, 1, 1}))}); }

TEST(Node, PlanesAreExactWhereTheyCanBe) {
  const Box a = box({1000, 2000, 3000}, {1255, 2001, 3000}), b = box({1001, 1900, 3100}, {1002, 1950, 3255});
  const auto children = node_children(make_node(std::vector{leaf(a, 7), leaf(b, 9)}));
  ASSERT_EQ(children.size(), 2u);
  EXPECT_EQ(children[0].box, a);
  EXPECT_EQ(children[1].box, b);
  EXPECT_EQ(children[0].word, ref_word(RefLeaf, 7));
  EXPECT_EQ(children[1].word, ref_word(RefLeaf, 9));
}

TEST(Node, GridIsTheFinestThatCovers) {
  EXPECT_EQ(node_of_width(1).exp_x, 0u);
  EXPECT_EQ(node_of_width(255).exp_x, 0u);
  EXPECT_EQ(node_of_width(256).exp_x, 1u);
  EXPECT_EQ(node_of_width(510).exp_x, 1u);
  EXPECT_EQ(node_of_width(511).exp_x, 2u);  // rounded up it takes 256 spacings of 2
  EXPECT_EQ(node_of_width((1 << 26) - 65).exp_x, 19u);
  EXPECT_EQ(node_of_width(255 << 18).exp_x, 18u);
  EXPECT_EQ(node_of_width((255 << 18) + 1).exp_x, 19u);
}

TEST(Node, PlanesAreRoundedOutward) {
  const Box wide = box({0, 0, 0}, {1020, 4, 4}), inner = box({5, 1, 1}, {9, 2, 2});
  const node_t node = make_node(std::vector{leaf(wide), leaf(inner)});
  EXPECT_EQ(node.exp_x, 2u);
  EXPECT_EQ(node.box1.x0, 1u);  // 5 -> 4
  EXPECT_EQ(node.box1.x1, 3u);  // 9 -> 12
  const node_t on_planes = make_node(std::vector{leaf(wide), leaf(box({8, 1, 1}, {12, 2, 2}))});
  EXPECT_EQ(on_planes.box1.x0, 2u);
  EXPECT_EQ(on_planes.box1.x1, 3u);
}

TEST(Node, HoldsItsChildrenAndLittleMore) {
  std::mt19937_64 random(5);
  const auto at = [&](std::int64_t limit) { return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(limit)); };
  for (int i = 0; i < 100000; ++i) {
    std::vector<NodeChild> children(1 + random() % 4);
    const std::int64_t size = std::int64_t{2} << at(26), limit = (std::int64_t{1} << 26) - size + 1;
    const Box::Corner origin = {at(limit), at(limit), at(limit)};
    for (NodeChild& child : children) {
      child = leaf({}, 1 + random() % 1000);
      for (int k = 0; k < 2; ++k) child.box.add({origin[0] + at(size), origin[1] + at(size), origin[2] + at(size)});
    }
    const node_t node = make_node(children);
    const auto read = node_children(unpack<node_t>(pack(node).data()));
    ASSERT_EQ(read.size(), children.size());
    const std::uint64_t exps[] = {node.exp_x, node.exp_y, node.exp_z};
    for (std::size_t k = 0; k < read.size(); ++k) {
      EXPECT_EQ(read[k].word, children[k].word);
      EXPECT_TRUE(read[k].box.holds(children[k].box));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_GT(read[k].box.low[axis] + (std::int64_t{1} << exps[axis]), children[k].box.low[axis]);
        EXPECT_LT(read[k].box.high[axis] - (std::int64_t{1} << exps[axis]), children[k].box.high[axis]);
      }
    }
  }
}

TEST(Box, OfATriangleIsPaddedByOneStep) {
  const prim_slot_t slot{.a = {.z = 30, .y = 20, .x = 10}, .b = {.z = 5, .y = 25, .x = 10}, .c = {.z = 7, .y = 7, .x = 70}, .kind = KindTriangle};
  EXPECT_EQ(padded_box(slot), box({9, 6, 4}, {71, 26, 31}));
}

TEST(Box, OfASphereIsPaddedByItsRounding) {
  prim_slot_t slot{.a = {.z = 1 << 25, .y = 1 << 25, .x = 1 << 25}, .b = {.x = 100}, .kind = KindSphere};
  const std::int64_t c = 1 << 25;
  EXPECT_EQ(padded_box(slot), box({c - 107, c - 107, c - 107}, {c + 107, c + 107, c + 107}));
  slot.b.x = (1 << 21) - 1;
  EXPECT_EQ(padded_box(slot).high[0], c + (1 << 21) - 1 + 7);
  slot.b.x = 1 << 21;
  EXPECT_EQ(padded_box(slot).high[0], c + (1 << 21) + 8);
}

}  // namespace
}  // namespace castray
