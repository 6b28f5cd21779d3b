// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Where the rays of a tile start: the RTL's tiles and frontiers equal the model's, in order, under
// stalls; and the model's frontier holds every primitive that a ray of the tile hits.
// Links the library.
#include "traverse/tile_start.hpp"

#include <cstdio>
#include <map>

#include "Vtile_start.h"
#include "camera/frame_setup.hpp"
#include "camera/tile_walk.hpp"
#include "dut.hpp"
#include "mem/prim_reader.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"
#include "traverse/lane.hpp"

namespace castray::tb {
namespace {

constexpr int kTileLog2 = 3, kSlots = 16;

// A scene, compiled for a frame, and its tiles.
struct World {
  World(const std::string& file, int width, int height) : image(compile(load_scene("scenes/" + file + ".json"), width, height)) {
    camera = frame_setup(image.frame);
    root.kind = image.header.root >> LineW;
    root.index = image.header.root & ((1u << LineW) - 1);
    window(0, 0, width, height);
  }
  void window(int x0, int y0, int x1, int y1) {
    job_t job;
    job.width = image.frame.width, job.height = image.frame.height;
    job.x0 = x0, job.y0 = y0, job.x1 = x1, job.y1 = y1;
    tiles.clear();
    for_each_tile(job, kTileLog2, kSlots, [&](const tile_t& tile) { tiles.push_back(tile); });
  }
  bool node_at(line_t index, node_t& node) const {
    if (index >= image.header.nodes.count) return false;
    node = load_node(image.bytes.data(), image.header, index);
    return true;
  }
  TileStart start(const tile_t& tile) const {
    return tile_start(tile, camera, root, [&](line_t index, node_t& node) { return node_at(index, node); });
  }

  SceneImage image;
  camera_t camera;
  ref_t root;
  std::vector<tile_t> tiles;
};

ray_t ray_at(const World& world, int x, int y) {
  pixel_tag_t tag;
  tag.x = static_cast<pixel_t>(x), tag.y = static_cast<pixel_t>(y);
  return ray_setup(ray_gen(world.camera, x, y), world.camera, tag);
}

class TileStartUnit : public testing::TestWithParam<Stalls> {
 protected:
  void use(const World& world) {
    dut->direct_i = 0;
    set_port(dut->eye_i, world.camera.eye);
    set_port(dut->root_i, world.root);
    dut->nodes_i = static_cast<std::uint32_t>(world.image.header.nodes.offset / LineBytes);
    dut->node_count_i = static_cast<std::uint32_t>(world.image.header.nodes.count);
    dut->in_valid_i = dut->corner_ready_i = dut->ray_valid_i = dut->out_ready_i = dut->req_ready_i = dut->fill_valid_i = 0;
    dut.reset();
  }

  // All tiles of the world through the unit; the cycles it took, or what fault it raised.
  long run(const World& world, Stalls stalls, error_t* fault = nullptr) {
    use(world);
    Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2), rays(stalls.source, stalls.burst, 3),
        memory(stalls.sink, stalls.burst, 4);
    std::deque<ray_t> corners;
    std::deque<std::pair<line_fill_t, long>> fills;
    std::map<std::uint64_t, std::array<node_t, 2>> store;
    std::size_t sent = 0, came = 0;
    bool offering = false;
    read = 0;
    const long first = dut.cycles();
    while (came < world.tiles.size() && !HasFailure()) {
      if (dut.cycles() - first > 4000 * static_cast<long>(world.tiles.size())) {
        ADD_FAILURE() << "hangs at tile " << came;
        break;
      }
      offering = offering || (sent < world.tiles.size() && source.open());
      dut->in_valid_i = offering;
      if (offering) set_port(dut->in_i, world.tiles[sent]);
      dut->corner_ready_i = rays.open();
      dut->ray_valid_i = !corners.empty() && rays.open();
      if (!corners.empty()) set_port(dut->ray_i, corners.front());
      dut->req_ready_i = memory.open();
      dut->fill_valid_i = !fills.empty() && fills.front().second <= dut.cycles();
      if (!fills.empty()) set_port(dut->fill_i, fills.front().first);
      dut->out_ready_i = sink.open();
      dut.settle();
      if (dut->fault_o != ErrNone) {
        if (fault) *fault = static_cast<error_t>(dut->fault_o);
        else ADD_FAILURE() << "fault " << int(dut->fault_o);
        return dut.cycles() - first;
      }
      read += dut->node_o;
      if (dut->store_valid_o) store[dut->store_slot_o][dut->store_second_o] = get_port<node_t>(dut->store_node_o);
      if (dut->out_valid_o && dut->out_ready_i) expect_tile(world, came++, get_port<started_t>(dut->out_o), store);
      if (dut->req_valid_o && dut->req_ready_i) {
        const auto req = get_port<line_req_t>(dut->req_o);
        line_fill_t fill;
        fill.miss = req.miss;
        EXPECT_LE((req.line + 1) * LineBytes, world.image.bytes.size());
        fill.data = load_line(world.image, req.line);
        fills.emplace_back(fill, dut.cycles() + 20);
      }
      if (dut->fill_valid_i && dut->fill_ready_o) fills.pop_front();
      if (dut->ray_valid_i && dut->ray_ready_o) corners.pop_front();
      if (dut->corner_valid_o && dut->corner_ready_i) {
        const auto tag = get_port<pixel_tag_t>(dut->corner_o);
        corners.push_back(ray_at(world, static_cast<int>(tag.x), static_cast<int>(tag.y)));
      }
      if (offering && dut->in_ready_o) ++sent, offering = false;
      dut.tick();
    }
    return dut.cycles() - first;
  }
  static auto load_line(const SceneImage& image, line_no_t line) -> decltype(line_fill_t::data) {
    decltype(line_fill_t::data) data{};
    std::memcpy(&data, &image.bytes[line * LineBytes], LineBytes);
    return data;
  }

  void expect_tile(const World& world, std::size_t at, const started_t& got, std::map<std::uint64_t, std::array<node_t, 2>>& store) {
    const tile_t& tile = world.tiles[at];
    const TileStart expected = world.start(tile);
    ASSERT_TRUE(got.tile == tile) << to_text(got.tile) << " instead of " << to_text(tile);
    ASSERT_EQ(got.start, expected.start) << to_text(tile);
    for (std::size_t i = 0; i < expected.nodes.count; ++i)
      ASSERT_TRUE(store[tile.slot][i] == expected.nodes.node[i])
          << to_text(tile) << " node " << i << "\n rtl   " << to_text(store[tile.slot][i]) << "\n model " << to_text(expected.nodes.node[i]);
    ++starts[expected.start];
    read_expected += expected.read;
  }

  Dut<Vtile_start> dut;
  long read = 0, read_expected = 0;
  std::map<std::uint64_t, int> starts;
};
INSTANTIATE_TEST_SUITE_P(Stalls, TileStartUnit, testing::ValuesIn(kStallPatterns));

TEST_P(TileStartUnit, MatchesModel) {
  for (const std::string scene : {"teapot", "teapot_interior", "spheres", "cube"}) {
    SCOPED_TRACE(scene);
    World world(scene, 120, 90);
    run(world, GetParam());
    EXPECT_EQ(read, read_expected);
    read_expected = 0;
    world.window(3, 5, 61, 41);
    run(world, GetParam());
    read_expected = 0;
  }
  for (const auto start : {TileEmpty, TileRoot, TileOne, TileTwo}) EXPECT_GT(starts[static_cast<std::uint64_t>(start)], 5) << start;
}

TEST_F(TileStartUnit, TakesFewCyclesATile) {
  const World world("teapot", 320, 240);
  const long cycles = run(world, {});
  std::printf("teapot base 320x240: %zu tiles, %.1f cycles and %.1f nodes each; empty %d, at the root %d, of one node %d, of two %d\n",
              world.tiles.size(), static_cast<double>(cycles) / static_cast<double>(world.tiles.size()),
              static_cast<double>(read) / static_cast<double>(world.tiles.size()), starts[TileEmpty], starts[TileRoot], starts[TileOne], starts[TileTwo]);
  EXPECT_LT(cycles, 65 * static_cast<long>(world.tiles.size()));
}

// Corner rays share a pipe with the rays of tiles that have left, so they must never wait for one to leave.
TEST_F(TileStartUnit, CornersAreTakenWhileNoTileMayLeave) {
  const World world("teapot", 320, 240);
  use(world);
  std::deque<ray_t> corners;
  std::size_t sent = 0, taken = 0;
  dut->corner_ready_i = 1;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    dut->in_valid_i = 1;
    set_port(dut->in_i, world.tiles[sent]);
    dut->ray_valid_i = !corners.empty();
    if (!corners.empty()) set_port(dut->ray_i, corners.front());
    dut.settle();
    if (dut->ray_valid_i && dut->ray_ready_o) corners.pop_front(), ++taken;
    if (dut->corner_valid_o) {
      const auto tag = get_port<pixel_tag_t>(dut->corner_o);
      corners.push_back(ray_at(world, static_cast<int>(tag.x), static_cast<int>(tag.y)));
    }
    if (dut->in_ready_o) ++sent;
    dut.tick();
  }
  EXPECT_EQ(sent, static_cast<std::size_t>(StartTiles));
  EXPECT_EQ(taken, 4 * sent);
}

TEST_F(TileStartUnit, DirectTilesPassAndStartAtTheRoot) {
  const World world("teapot", 64, 64);
  use(world);
  dut->direct_i = 1;
  dut->out_ready_i = 1;
  for (const tile_t& tile : world.tiles) {
    set_port(dut->in_i, tile);
    dut->in_valid_i = 1;
    dut.settle();
    ASSERT_TRUE(dut->in_ready_o);
    dut.tick();
    dut->in_valid_i = 0;
    dut.settle();
    ASSERT_TRUE(dut->out_valid_o && !dut->corner_valid_o);
    const auto out = get_port<started_t>(dut->out_o);
    EXPECT_TRUE(out.tile == tile);
    EXPECT_EQ(out.start, static_cast<std::uint64_t>(TileRoot));
    dut.tick();
  }
  EXPECT_TRUE(dut->idle_o);
}

// Boxes with a low plane above the high one hold nothing, and move no grid.
TEST_F(TileStartUnit, TurnedBoxesHoldNothing) {
  std::mt19937 rng(9);
  for (int round = 0; round < 12; ++round) {
    World world("teapot", 64, 48);
    std::uint64_t turned = 0;
    for (std::uint64_t i = 0; i < world.image.header.nodes.count; ++i) {
      node_t node = load_node(world.image.bytes.data(), world.image.header, i);
      for (child_box_t* const box : {&node.box0, &node.box1, &node.box2, &node.box3}) {
        if (rng() % 8 != 0) continue;
        plane_t* const pairs[][2] = {{&box->x0, &box->x1}, {&box->y0, &box->y1}, {&box->z0, &box->z1}};
        auto& [low, high] = pairs[rng() % 3];
        std::swap(*low, *high);
        turned += *low > *high;
      }
      store_record(&world.image.bytes[world.image.header.nodes.offset + i * NodeBytes], node);
    }
    ASSERT_GT(turned, 100u);
    run(world, {});
  }
  EXPECT_GT(starts[TileOne] + starts[TileTwo], 50);
}

// Each illegal node that is met ends it with ErrNode.
TEST_F(TileStartUnit, AnIllegalNodeIsAFault) {
  const std::function<void(node_t&)> spoils[] = {
      [](node_t& node) { node.exp_y = MaxPlaneExp + 1; },
      [](node_t& node) { node.ref1 |= 1u << 24; },
      [](node_t& node) { node.ref0 = static_cast<ref_word_t>(RefNode) << LineW; },          // not behind its parent
      [](node_t& node) { node.ref0 = static_cast<ref_word_t>(RefTile) << LineW; },
      [](node_t& node) { node.ref0 = 0; },                                                   // others behind the end
      [](node_t& node) { node.ref1 = (static_cast<ref_word_t>(RefNode) << LineW) | 0x3fffff; },  // outside the section
  };
  for (const auto& spoil : spoils) {
    World world("teapot", 64, 48);
    node_t node = load_node(world.image.bytes.data(), world.image.header, world.root.index);
    spoil(node);
    store_record(&world.image.bytes[world.image.header.nodes.offset + world.root.index * NodeBytes], node);
    error_t fault = ErrNone;
    run(world, {}, &fault);
    EXPECT_EQ(fault, ErrNode);
  }
}

// Every primitive that a ray of the tile hits lies under the frontier, in a box that the ray's own
// test does not drop: a ray from there sees what it sees of all primitives.
TEST(TileStartModel, FrontiersHoldWhatRaysHit) {
  for (const std::string scene : {"teapot", "teapot_tight", "teapot_interior", "teapot_rotated", "spheres", "cube"}) {
    const World world(scene, 48, 36);
    const std::vector<prim_slot_t> slots = read_slots(world.image.bytes.data(), world.image.header);
    long hits = 0;
    for (const tile_t& tile : world.tiles) {
      const TileStart start = world.start(tile);
      ASSERT_EQ(start.error, ErrNone);
      for_each_pixel(tile, [&](const pixel_tag_t& tag) {
        if ((tag.x + 3 * tag.y) % 4 != 0) return;
        const ray_t ray = ray_at(world, static_cast<int>(tag.x), static_cast<int>(tag.y));
        std::uint64_t tests = 0;
        const hit_t hit = lane(ray, slots, tests, [](const cand_t&, const result_t*) {});
        if (!hit.found) return;
        ++hits;
        ASSERT_NE(start.start, static_cast<std::uint64_t>(TileEmpty)) << scene << ": " << to_text(tag);
      });
    }
    EXPECT_GT(hits, 50) << scene;
  }
}

}  // namespace
}  // namespace castray::tb
