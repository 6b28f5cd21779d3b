// SPDX-License-Identifier: Apache-2.0
// Whole small frames, RTL against model: every pixel, every raw hit record, the work counters, on 1
// to 4 lanes, under every pattern of stalls and both memories.
// Cores: l1c32t3p1m0 l2c32t3p1m128 l3c32t3p2m128 l4c32t3p2m128
#include "frame/frame.hpp"

namespace castray::tb {
namespace {

class Lanes : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Cores, Lanes, testing::Values(1, 2, 3, 4));

TEST_P(Lanes, TriangleAndSphereScenesMatchTheModel) {
  for (const std::string stalls : {"none", "uniform", "bursty", "turn"}) {
    Core core(core_of(GetParam(), stalls, 3));
    for (const std::string name : {"spheres", "cube"}) {
      SCOPED_TRACE(name + ", stalls " + stalls);
      const Scene scene = scene_of(name);
      const SceneImage image = compile(scene, 40, 30);
      for (const sim::Mode mode : {sim::Mode::kBrute, sim::Mode::kBvh, sim::Mode::kBvhRoot}) expect_frame(core, image, {.mode = mode});
    }
  }
}

// Every scene on every number of lanes; each pattern of stalls meets each number of lanes.
TEST_P(Lanes, EverySceneInTheHierarchyMatchesTheModel) {
  const std::vector<std::string>& scenes = scene_names();
  const auto patterns = sim::Stalls::names();
  ASSERT_GE(scenes.size(), patterns.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::string stalls = patterns[(i + static_cast<std::size_t>(GetParam())) % patterns.size()];
    SCOPED_TRACE(scenes[i] + ", stalls " + stalls);
    Core core(core_of(GetParam(), stalls, 5));
    expect_frame(core, compile(scene_of(scenes[i]), 40, 30));
  }
}

class Patterns : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Stalls, Patterns, testing::ValuesIn(sim::Stalls::names()), [](const auto& info) { return info.param; });

TEST_P(Patterns, TeapotMatchesTheModelAndChannelsAreBlocked) {
  static const SceneImage image = compile(scene_of("teapot"), 16, 12);
  Core core(core_of(3, GetParam(), 11));
  expect_frame(core, image, {.mode = sim::Mode::kBrute});
  const auto shares = core.device.memory().shares();
  for (unsigned i = 0; i < sim::kChannels; ++i) {
    const sim::StallShare& share = shares[i];
    if (core.device.memory().stalls_use(static_cast<sim::Channel>(i))) EXPECT_GE(share.share(), 0.25) << sim::kChannelNames[i] << " of " << share.wanted;
  }
}

TEST_P(Patterns, TeapotInTheHierarchyMatchesTheModel) {
  static const SceneImage image = compile(scene_of("teapot"), 80, 60);
  Core core(core_of(3, GetParam(), 12));
  for (const bool hits : {true, false}) expect_frame(core, image, {.hits = hits});
}

// The records hold the nodes and tests of each ray, and these add up to the frame's counters.
TEST(Frames, TellTheWorkOfEachRay) {
  Core core(core_of(3, "uniform"));
  const SceneImage image = compile(scene_of("spheres"), 40, 30);
  core.driver.load(image);
  for (const sim::Mode mode : {sim::Mode::kBrute, sim::Mode::kBvh, sim::Mode::kBvhRoot}) {
    const sim::RenderOptions options{.work = true, .mode = mode};
    const sim::Rendering rtl = core.driver.render(options);
    EXPECT_TRUE(equal(rtl, sim::run_model(image, options)));
    std::uint64_t nodes = 0, tests = 0;
    for (std::size_t i = 0; i < rtl.pixels.size(); ++i) nodes += rtl.hit(i).nodes, tests += rtl.hit(i).tests;
    EXPECT_EQ(nodes, rtl.counters[CntNodes]);
    EXPECT_EQ(tests, rtl.counters[CntTests]);
    EXPECT_GT(tests, 1000u);
    EXPECT_EQ(nodes > 1000, mode != sim::Mode::kBrute);
  }
}

// Where nothing is asked for but the picture: what the hierarchy sees is what brute force sees.
TEST_P(Lanes, HierarchyEqualsBruteForce) {
  Core core(core_of(GetParam()));
  const int teapot = GetParam() == 4 ? 24 : 8;   // by brute force fewer lanes take longer
  for (const auto& [name, width] : {std::pair{"cube", 40}, {"spheres", 40}, {"tiny", 24}, {"teapot_tight", teapot}}) {
    SCOPED_TRACE(name);
    core.driver.load(compile(scene_of(name), width, width * 3 / 4));
    const sim::Rendering brute = core.driver.render({.mode = sim::Mode::kBrute});
    EXPECT_EQ(brute.error, ErrNone);
    for (const sim::Mode mode : {sim::Mode::kBvh, sim::Mode::kBvhRoot}) {
      const sim::Rendering tree = core.driver.render({.mode = mode});
      EXPECT_EQ(tree.error, ErrNone);
      EXPECT_TRUE(sim::compare(tree, brute).equal());
    }
  }
}

TEST(Frames, HpMemoryMatchesTheModel) {
  Core core(core_of(3, "none", 1, "hp"));
  expect_frame(core, compile(scene_of("spheres"), 40, 30));
  EXPECT_LE(core.device.memory().counters().most_reads, 8u);
  EXPECT_LE(core.device.memory().counters().most_writes, 8u);
}

TEST(Frames, ZOrderGivesTheSamePicture) {
  Core core(core_of(3));
  const SceneImage image = compile(scene_of("spheres"), 53, 37);
  core.driver.load(image);
  const sim::Rendering rows = core.driver.render({.hits = true, .z_order = false, .window = {}});
  const sim::Rendering curve = core.driver.render({.hits = true, .z_order = true, .window = {}});
  EXPECT_TRUE(equal(curve, rows));
  EXPECT_TRUE(equal(rows, sim::run_model(image)));
}

// Pixels outside the window keep what was there; inside they are those of the whole frame.
TEST(Frames, WindowsAreParts) {
  Core core(core_of(3, "uniform"));
  const SceneImage image = compile(scene_of("spheres"), 40, 30);
  const sim::PixelWindow windows[] = {{0, 0, 1, 1}, {39, 29, 40, 30}, {5, 7, 6, 29}, {3, 11, 31, 12}, {8, 8, 16, 16}, {7, 5, 25, 18}};
  for (const sim::PixelWindow& window : windows) {
    SCOPED_TRACE(std::to_string(window.x0) + ", " + std::to_string(window.y0));
    for (const bool hits : {true, false}) {
      const sim::RenderOptions options{.hits = hits, .window = window};
      expect_frame(core, image, options);
    }
  }
}

TEST(Frames, PixelFormatAndOddSizes) {
  Core core(core_of(2, "bursty"));
  Scene scene = scene_of("spheres");
  for (const PixelFormat format : {PixelFormat::Rgba8, PixelFormat::Bgra8}) {
    scene.pixel_format = format;
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 1}, {1, 19}, {33, 9}}) expect_frame(core, compile(scene, width, height));
  }
}

// A wide and a high frame, of which only the last pixels are rendered.
TEST(Frames, LargestSize) {
  Core core(core_of(3));
  const Scene scene = scene_of("cube");
  expect_frame(core, compile(scene, 4096, 16), {.window = sim::PixelWindow{4080, 0, 4096, 16}});
  expect_frame(core, compile(scene, 16, 4096), {.window = sim::PixelWindow{0, 4080, 16, 4096}});
}

TEST(Frames, CountersAgreeWithTheBus) {
  Core core(core_of(3));
  core.driver.load(compile(scene_of("spheres"), 40, 30));
  const std::uint64_t before = core.device.cycle();
  const sim::Rendering rtl = core.driver.render();
  EXPECT_EQ(rtl.counters[CntReadBeats], core.device.memory().counters().read_beats);
  EXPECT_EQ(rtl.counters[CntWriteBeats], core.device.memory().counters().write_beats);
  EXPECT_EQ(rtl.counters[CntAttrHits] + rtl.counters[CntAttrMisses], rtl.counters[CntHits]);
  EXPECT_LT(rtl.cycles(), core.device.cycle() - before);
  const std::uint64_t turn = rtl.counters.size(), reads = 2 * turn;   // a word of a counter is read in its turn
  EXPECT_GT(rtl.cycles() + reads * (turn + 10) + 500, core.device.cycle() - before) << "the rest is register accesses";
}

// What each pipe takes of a hit, a node, a candidate; triangles never wait for a root. Who may wait is one a lane, or a client.
TEST(Frames, PipesAndWaitsAreCounted) {
  for (const std::string name : {"cube", "spheres"}) {
    SCOPED_TRACE(name);
    Core core(core_of(3, "uniform"));
    core.driver.load(compile(scene_of(name), 40, 30));
    for (const sim::Mode mode : {sim::Mode::kBrute, sim::Mode::kBvh}) {
      const sim::Rendering rtl = core.driver.render({.hits = true, .mode = mode});
      const auto& counts = rtl.counters;
      EXPECT_EQ(counts[CntShaderBusy], 2 * counts[CntHits]);
      EXPECT_EQ(counts[CntTileBusy], 4 * counts[CntTileNodes]);
      EXPECT_GE(counts[CntHitUnitBusy], counts[CntCandidates]);
      if (name == "cube") EXPECT_EQ(counts[CntHitUnitBusy], counts[CntCandidates]);
      for (const auto busy : {CntHitUnitBusy, CntShaderBusy, CntTileBusy}) EXPECT_LE(counts[static_cast<std::size_t>(busy)], rtl.cycles());
      for (const auto waits : {CntStarved, CntHitWaits, CntWriteWaits}) EXPECT_GT(counts[static_cast<std::size_t>(waits)], 0u) << waits;
      EXPECT_LE(counts[CntStarved], 3 * rtl.cycles());
      EXPECT_EQ(core.device.read_reg(static_cast<unsigned>(RegCounters + 8 * CntStarved)), counts[CntStarved]) << "held after the end";
      EXPECT_LE(counts[CntHitWaits], 3 * rtl.cycles());
      EXPECT_LE(counts[CntWriteWaits], 2 * rtl.cycles());
    }
  }
}

// The same job takes the same cycles, whatever ran before.
TEST(Frames, CyclesDoNotDependOnTheJobBefore) {
  Core core(core_of(3));
  const SceneImage spheres = compile(scene_of("spheres"), 40, 30), cube = compile(scene_of("cube"), 24, 24);
  core.driver.load(spheres);
  const std::uint64_t first = core.driver.render().cycles();
  core.driver.load(cube);
  core.driver.render();
  core.driver.load(spheres);
  EXPECT_EQ(core.driver.render().cycles(), first);
}

}  // namespace
}  // namespace castray::tb
