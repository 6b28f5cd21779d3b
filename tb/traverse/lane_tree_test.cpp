// SPDX-License-Identifier: Apache-2.0
// Runs long.
// A lane in the hierarchy against its model: each ray's hit, nodes and tests, under stalls and with
// small caches; from tiles' frontiers; the error of every image that is not one.
// Links the library.
// Verilator: -GContexts=7 -GNodeLines=32 -GLeafLines=16
#include "../frame/random_scene.hpp"
#include "lane_tree_run.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

std::vector<LaneRay> random_rays(const SceneImage& image, const Tree& tree, int count, unsigned seed) {
  RayMaker maker(image, seed);
  std::vector<LaneRay> rays;
  for (int i = 0; i < count; ++i) {
    ray_t ray = maker.make();
    if (maker.one_in(20)) ray.valid = 0;
    rays.push_back({ray, maker.one_in(30) ? start_t{} : tree.root()});
  }
  return rays;
}

class LaneTreeStalls : public testing::TestWithParam<Stalls> {};
INSTANTIATE_TEST_SUITE_P(Patterns, LaneTreeStalls, testing::ValuesIn(kStallPatterns), [](const auto& info) { return std::string(info.param.name); });

TEST_P(LaneTreeStalls, MatchesModelOnRandomScenes) {
  LaneTotals all;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const RandomScene random = random_scene(seed);
    SCOPED_TRACE(random.text);
    const SceneImage image = compile(random.scene, 1, 1);
    LaneTree lane(image, GetParam(), seed, 1 + static_cast<int>(seed % 40));
    lane.expect_hits(random_rays(image, lane.tree, 60, seed));
    if (HasFailure()) return;
    all.rays += lane.totals.rays, all.hits += lane.totals.hits, all.nodes += lane.totals.nodes;
  }
  EXPECT_GT(all.hits, all.rays / 4);
  EXPECT_GT(all.nodes, 2 * all.rays);
}

TEST_P(LaneTreeStalls, MatchesModelOnTheTeapot) {
  const SceneImage image = compile(load_scene("scenes/teapot.json"), 320, 240);
  LaneTree lane(image, GetParam(), 3, 30);
  lane.expect_hits(random_rays(image, lane.tree, 1500, 3));
  EXPECT_GT(lane.totals.nodes, 3000);
  EXPECT_GT(lane.events["node_miss"], 1000);
  EXPECT_GT(lane.events["leaf_miss"], 300);
}

// ---- Tiles: rays start at one or two nodes on the chip ----

node_t only(node_t node, std::initializer_list<int> children) {
  const ref_word_t words[] = {node.ref0, node.ref1, node.ref2, node.ref3};
  const child_box_t boxes[] = {node.box0, node.box1, node.box2, node.box3};
  ref_word_t* const to_word[] = {&node.ref0, &node.ref1, &node.ref2, &node.ref3};
  child_box_t* const to_box[] = {&node.box0, &node.box1, &node.box2, &node.box3};
  int at = 0;
  for (ref_word_t* word : to_word) *word = 0;
  for (const int child : children) *to_word[at] = words[child], *to_box[at++] = boxes[child];
  return node;
}

TEST(LaneTree, StartsAtTilesFrontiers) {
  const SceneImage image = compile(load_scene("scenes/teapot.json"), 320, 240);
  LaneTree lane(image, kStallPatterns[3], 5);
  const node_t root = load_node(image.bytes.data(), image.header, 0);
  std::vector<node_t> tiles(32);
  for (int i = 0; i < 32; i += 2) tiles[i] = i % 4 ? root : only(root, {0, 3}), tiles[i + 1] = i % 4 ? only(root, {2}) : only(root, {1, 2});
  lane.write_tile(tiles);
  std::vector<LaneRay> rays = random_rays(image, lane.tree, 300, 8);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    start_t& start = rays[i].start;
    start = {};
    start.first.kind = RefTile, start.first.index = i % 32;
    if (i % 4 == 0) start.second.kind = RefTile, start.second.index = i % 32 + 1;
  }
  lane.expect_hits(rays);
  EXPECT_GT(lane.totals.hits, 50);
}

// ---- Images made for it: errors, and how long things take ----

class LaneImages : public testing::Test {
 protected:
  SceneImage image = compile(load_scene("scenes/spheres.json"), 64, 64);

  std::uint8_t* node_at(std::uint64_t index) { return &image.bytes[image.header.nodes.offset + index * NodeBytes]; }
  node_t node(std::uint64_t index) { return load_node(image.bytes.data(), image.header, index); }
  void put(std::uint64_t index, const node_t& node) { store_record(node_at(index), node); }
  static ref_word_t word(std::int64_t kind, std::uint64_t index) { return static_cast<ref_word_t>(kind) << LineW | index; }
  // Along z through everything, so that every box of the root is met.
  static LaneRay through(const Tree& tree) {
    camera_t camera;
    camera.eye.x = camera.eye.y = 1 << (CoordW - 1);
    dir_t dir;
    dir.z = 1 << 20;
    return {slab_setup(ray_setup(dir, camera, {})), tree.root()};
  }
  // A node whose children cover everything.
  static node_t everywhere(std::initializer_list<ref_word_t> words) {
    node_t n;
    n.exp_x = n.exp_y = n.exp_z = CoordW - 8 + 1;
    child_box_t all;
    all.x1 = all.y1 = all.z1 = 255;
    n.box0 = n.box1 = n.box2 = n.box3 = all;
    ref_word_t* const to[] = {&n.ref0, &n.ref1, &n.ref2, &n.ref3};
    int at = 0;
    for (const ref_word_t w : words) *to[at++] = w;
    return n;
  }
  void expect(error_t error, const char* what, steps_t limit = 1000) {
    SCOPED_TRACE(what);
    LaneTree lane(image, {}, 1);
    lane.tree.limit = limit;
    EXPECT_EQ(lane.expect_one(through(lane.tree)), error);
  }
};

TEST_F(LaneImages, AreEachFound) {
  ASSERT_GE(image.header.nodes.count, 2u);
  const std::uint64_t nodes = image.header.nodes.count, lines = image.header.lines.count;
  put(0, everywhere({word(RefLeaf, lines - 1)}));
  expect(ErrNone, "the last leaf");
  put(0, everywhere({word(RefLeaf, lines)}));
  expect(ErrLeaf, "a leaf behind the lines");
  put(0, everywhere({word(RefNode, nodes)}));
  expect(ErrNode, "a node behind the nodes");
  put(0, everywhere({word(RefNode, 0)}));
  expect(ErrNode, "a node below itself");
  put(1, everywhere({word(RefLeaf, 0), word(RefNode, 0)}));
  put(0, everywhere({word(RefNode, 1)}));
  expect(ErrNode, "a child before its parent");
  put(0, everywhere({word(RefTile, 0)}));
  expect(ErrNode, "a tile's entry in memory");
  put(0, everywhere({0, word(RefLeaf, 0)}));
  expect(ErrNode, "a child behind the end of the list");
  node_t coarse = everywhere({word(RefLeaf, 0)});
  coarse.exp_y = MaxPlaneExp + 1;
  put(0, coarse);
  expect(ErrNode, "a spacing that is too large");
  put(0, everywhere({word(RefLeaf, 0)}));
  expect(ErrNone, "one leaf");
  prim_slot_t slot = load_slot(image.bytes.data(), image.header, 1);
  slot.number = image.header.primitives;
  store_record(&image.bytes[image.header.lines.offset + SlotBytes], slot);
  expect(ErrPrimitive, "a number that is too high");
}

TEST_F(LaneImages, ANodeMoreThanTheLimit) {
  put(1, everywhere({word(RefLeaf, 0)}));
  put(0, everywhere({word(RefNode, 1)}));
  expect(ErrNone, "as many", 2);
  expect(ErrSteps, "one more", 1);
}

// A chain of nodes that each leave a leaf behind: as many levels as the stack has frames, and one more.
TEST_F(LaneImages, ALevelMoreThanTheStack) {
  const std::uint64_t first = image.header.nodes.offset;
  image.bytes.resize(first + 64 * NodeBytes);
  image.header.nodes.count = 64;
  store_record(image.bytes.data(), image.header);
  const auto chain = [&](std::uint64_t levels) {
    for (std::uint64_t i = 0; i < levels; ++i) put(i, everywhere({word(i + 1 < levels ? RefNode : RefLeaf, i + 1 < levels ? i + 1 : 0), word(RefLeaf, 0)}));
  };
  for (const std::int64_t levels : {StackFrames, StackFrames + 1}) {
    chain(static_cast<std::uint64_t>(levels));
    expect(levels == StackFrames ? ErrNone : ErrStack, "a chain from its root");
  }
  // From a frontier of two nodes, the first of which leads to the second level: as many levels as the host makes.
  for (const std::int64_t levels : {MaxLevels, MaxLevels + 1}) {
    chain(static_cast<std::uint64_t>(levels));
    LaneTree lane(image, {}, 1);
    lane.write_tile({everywhere({word(RefNode, 1), word(RefLeaf, 0)}), everywhere({word(RefLeaf, 0)})});
    LaneRay ray = through(lane.tree);
    ray.start.first.kind = ray.start.second.kind = RefTile;
    ray.start.first.index = 0, ray.start.second.index = 1;
    EXPECT_EQ(lane.expect_one(ray), levels == MaxLevels ? ErrNone : ErrStack) << levels << " levels from a frontier";
  }
}

// What docs/lane.md says of the cycles that a ray takes when all lines are in the caches.
TEST_F(LaneImages, TakesTheseCycles) {
  const std::uint64_t first = image.header.nodes.offset;
  image.bytes.resize(first + 8 * NodeBytes);
  image.header.nodes.count = 8;
  store_record(image.bytes.data(), image.header);
  // A ray through `nodes` nodes, the last of which leads nowhere, or to a leaf.
  const auto cycles = [&](std::uint64_t nodes, bool leaf) {
    for (std::uint64_t i = 0; i + 1 < nodes; ++i) put(i, everywhere({word(RefNode, i + 1)}));
    put(nodes - 1, leaf ? everywhere({word(RefLeaf, 0)}) : node_t{});
    LaneTree lane(image, {}, 1);
    lane.expect_hits({through(lane.tree)});
    const long before = lane.cycles;
    lane.expect_hits({through(lane.tree)});
    return lane.cycles - before;
  };
  // Primitives of the first leaf: missed, or hit. The ray goes through the middle along z.
  const auto primitives = [&](bool hit) {
    const std::uint64_t middle = 1 << (CoordW - 1), off = hit ? 0 : 1 << 20;
    for (int i = 0; i < 2; ++i) {
      prim_slot_t slot;
      slot.kind = KindTriangle, slot.number = static_cast<std::uint64_t>(i);
      slot.a = {.z = middle, .y = middle - 1000, .x = middle - 1000 + off};
      slot.b = {.z = middle, .y = middle - 1000, .x = middle + 1000 + off};
      slot.c = {.z = middle, .y = middle + 1000, .x = middle + off};
      store_record(&image.bytes[image.header.lines.offset + static_cast<std::uint64_t>(i) * SlotBytes], slot);
    }
  };
  const long one = cycles(1, false);
  EXPECT_EQ(one, 17) << "in and out, one node";
  EXPECT_EQ(cycles(5, false) - one, 4 * 13) << "each further node";
  primitives(false);
  EXPECT_EQ(cycles(1, true) - one, 19) << "a leaf of two triangles that are missed";
  primitives(true);
  EXPECT_EQ(cycles(1, true) - one, 42) << "a leaf of two triangles that are hit";
}

// Flipped bits in nodes and lines: the same error as the model's, or the same hit.
TEST_F(LaneImages, OfDamagedImagesAreTheModels) {
  const SceneImage good = image;
  std::map<error_t, int> seen;
  std::mt19937 rng(1);
  for (unsigned i = 0; i < 1200 && !HasFailure(); ++i) {
    image = good;
    const section_t& section = i % 4 ? image.header.nodes : image.header.lines;
    for (unsigned flip = 0; flip <= i % 3; ++flip)
      image.bytes[section.offset + rng() % (section.count * LineBytes)] ^= static_cast<std::uint8_t>(1u << rng() % 8);
    LaneTree lane(image, {}, i, 3);
    lane.tree.limit = 200;
    for (const LaneRay& ray : random_rays(good, lane.tree, 3, i)) ++seen[lane.expect_one(ray)];
  }
  EXPECT_GT(seen[ErrNone], 200);
  EXPECT_GT(seen[ErrNode], 20);
  EXPECT_GT(seen[ErrLeaf], 5);
  EXPECT_GT(seen[ErrPrimitive], 5);
}

}  // namespace
}  // namespace castray::tb
