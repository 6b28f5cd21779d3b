// SPDX-License-Identifier: Apache-2.0
// The rays of whole windows equal the models' along the walk, under stalls of gather and lanes; and
// what it says of rays still to come is true in every cycle.
// Verilator: -GTileLog2=2 -GSlots=5
#include "Vray_source.h"
#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "camera/tile_walk.hpp"
#include "dut.hpp"
#include "windows.hpp"

namespace castray::tb {
namespace {

constexpr int kTileLog2 = 2, kSlots = 5;

// A job on a window of 64 x 48 pixels in which no tile is started in the hierarchy.
job_t brute(std::uint64_t x0, std::uint64_t y0, std::uint64_t x1, std::uint64_t y1, bool z_order) {
  job_t job = window(64, 48, x0, y0, x1, y1, z_order);
  job.brute = 1;
  return job;
}

class RaySource : public ::testing::TestWithParam<Stalls> {
 protected:
  RaySource() {
    camera.eye = {.z = 3, .y = 1000, .x = (1u << CoordW) - 1};
    camera.right = {.z = 1 << 20, .y = 0, .x = 3 << 28};
    camera.up = {.z = 0, .y = 5 << 27, .x = 77};
    camera.ahead = {.z = -(std::int64_t{1} << 40), .y = 12345, .x = 1 << 30};
    camera.width = 64;
    camera.height = 48;
    set_port(dut->camera_i, camera);
    dut->fill_line_valid_i = dut->req_ready_i = dut->left_i = 0;   // of the hierarchy: it is not followed
    dut->list_valid_i = dut->list_done_i = 0;
    dut->miss_ready_i = dut->fill_ready_i = 1;
    dut.reset();
  }

  void follow(const job_t& job, Stalls stalls) {
    std::vector<ray_t> rays;
    tile_walk(job, kTileLog2, kSlots, [&](const pixel_tag_t& tag) {
      rays.push_back(slab_setup(ray_setup(ray_gen(camera, static_cast<int>(tag.x), static_cast<int>(tag.y)), camera, tag)));
    });
    Gate gather(stalls.source, stalls.burst, 5), sink(stalls.sink, stalls.burst, 6);
    set_port(dut->job_i, job);
    dut->tile_ready_i = dut->out_ready_i = 0;
    dut->start_i = 1;
    dut.tick();
    dut->start_i = 0;
    std::size_t granted = 0, came = 0;  // pixels of granted tiles; rays
    unsigned slot = 0;
    for (long cycle = 0; cycle < 20000 && came < rays.size(); ++cycle) {
      dut->tile_ready_i = gather.open();
      dut->out_ready_i = sink.open();
      dut->tile_slot_i = static_cast<std::uint8_t>(slot);
      dut.settle();
      ASSERT_FALSE(dut->exhausted_o) << came << " of " << rays.size() << " rays came";
      if (came == granted) ASSERT_TRUE(dut->none_in_setup_o);
      if (dut->tile_valid_o && dut->tile_ready_i) {
        const auto tile = get_port<tile_t>(dut->tile_o);
        granted += tile.width * tile.height;
        slot = (slot + 1) % kSlots;
      }
      if (dut->out_valid_o) {
        ASSERT_FALSE(dut->none_in_setup_o);
        const auto ray = get_port<ray_t>(dut->out_o);
        ASSERT_TRUE(ray == rays[came]) << "ray " << came << "\n rtl   " << to_text(ray) << "\n model " << to_text(rays[came]);
        came += dut->out_ready_i;
      }
      dut.tick();
    }
    ASSERT_EQ(came, rays.size());
    for (int i = 0; i < 30 && !dut->walk_done_o; ++i) dut.tick();
    EXPECT_TRUE(dut->walk_done_o);
    EXPECT_TRUE(dut->none_in_setup_o);
    EXPECT_TRUE(dut->exhausted_o);
  }

  Dut<Vray_source> dut;
  camera_t camera;
};
INSTANTIATE_TEST_SUITE_P(Stalls, RaySource, ::testing::ValuesIn(kStallPatterns));

TEST_P(RaySource, MatchesModels) {
  follow(brute(0, 0, 64, 48, false), GetParam());
  follow(brute(0, 0, 64, 48, true), GetParam());
  follow(brute(5, 7, 6, 8, false), GetParam());
  follow(brute(3, 2, 50, 45, true), GetParam());
}

// The rays of a list instead: their setups, and nothing else comes.
TEST_P(RaySource, GivesTheRaysOfAList) {
  constexpr std::size_t kRays = 500;
  job_t job = window(64, 48, 0, 0, 64, 48, false);
  job.is_list = 1;
  std::mt19937_64 rng(8);
  std::vector<ray_req_t> list(kRays);
  for (std::size_t i = 0; i < kRays; ++i) {
    packed_t<ray_req_t> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(rng());
    list[i] = unpack<ray_req_t>(words.data());
  }
  Gate source(GetParam().source, GetParam().burst, 5), sink(GetParam().sink, GetParam().burst, 6);
  set_port(dut->job_i, job);
  dut->tile_ready_i = 1;
  dut->start_i = 0;
  std::size_t given = 0, came = 0;
  for (long cycle = 0; cycle < 20000 && came < kRays; ++cycle) {
    if (!dut->list_valid_i && given < kRays && source.open()) {
      dut->list_valid_i = 1;
      set_port(dut->list_i, list[given]);
    }
    dut->list_done_i = given == kRays;
    dut->out_ready_i = sink.open();
    dut.settle();
    ASSERT_FALSE(dut->exhausted_o) << came;
    ASSERT_EQ(dut->none_in_setup_o, came == given);
    ASSERT_FALSE(dut->tile_valid_o || dut->miss_valid_o || dut->fill_valid_o || dut->deal_valid_o);
    if (dut->out_valid_o && dut->out_ready_i) {
      ASSERT_TRUE(get_port<ray_t>(dut->out_o) == slab_setup(ray_setup(list[came]))) << came;
      ++came;
    }
    const bool taken = dut->list_valid_i && dut->list_ready_o;
    given += taken;
    dut.tick();
    if (taken) dut->list_valid_i = 0;
  }
  EXPECT_EQ(came, kRays);
  dut->list_done_i = 1;
  dut.settle();
  EXPECT_TRUE(dut->exhausted_o);
}

// With the lanes shut the walk runs ahead into the pipes, and ends there: done, but not exhausted.
TEST_F(RaySource, IsNotExhaustedWhileRaysAreSetUp) {
  set_port(dut->job_i, brute(8, 8, 12, 12, false));
  dut->tile_ready_i = 1;
  dut->out_ready_i = 0;
  dut->start_i = 1;
  dut.tick();
  dut->start_i = 0;
  for (int i = 0; i < 100; ++i) dut.tick();
  EXPECT_TRUE(dut->walk_done_o);
  EXPECT_FALSE(dut->none_in_setup_o);
  EXPECT_FALSE(dut->exhausted_o);
  dut->out_ready_i = 1;
  for (int i = 0; i < 15; ++i) dut.tick();
  EXPECT_FALSE(dut->exhausted_o) << "one ray is still being set up";
  dut.tick();
  EXPECT_TRUE(dut->exhausted_o);
}

}  // namespace
}  // namespace castray::tb
