// SPDX-License-Identifier: Apache-2.0
// ray_gen: equal to its model under stalls, corners of frames by hand, extremes of Q3.42.
#include "Vray_gen.h"
#include "camera/ray_gen.hpp"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kStepMax = (std::int64_t{1} << (dir_step_t_bits - 1)) - 1;
constexpr std::int64_t kCompMax = (std::int64_t{1} << (dir_comp_t_bits - 1)) - 1;
constexpr int kStages = 4;

dir_step3_t step3(std::int64_t x, std::int64_t y, std::int64_t z) { return {.z = z, .y = y, .x = x}; }

pixel_dir_t model(const camera_t& camera, const pixel_tag_t& tag) {
  return {.dir = ray_gen(camera, static_cast<int>(tag.x), static_cast<int>(tag.y)), .tag = tag};
}

class RayGen : public ::testing::TestWithParam<Stalls> {
 protected:
  void expect_model(const camera_t& camera, const std::vector<pixel_tag_t>& tags, Stalls stalls = {}) {
    set_port(dut->camera_i, camera);
    const auto got = run_stream<pixel_dir_t>(dut, tags, tags.size(), stalls);
    ASSERT_EQ(got.size(), tags.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      ASSERT_TRUE(got[i] == model(camera, tags[i]))
          << "camera " << to_text(camera) << "\n rtl   " << to_text(got[i]) << "\n model " << to_text(model(camera, tags[i]));
  }
  Dut<Vray_gen> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, RayGen, ::testing::ValuesIn(kStallPatterns));

TEST_P(RayGen, MatchesModel) {
  std::mt19937_64 rng(3);
  for (int frame = 0; frame < 20; ++frame) {
    packed_t<camera_t> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(rng());
    camera_t camera = unpack<camera_t>(words.data());
    camera.width = 1 + rng() % 4096;
    camera.height = 1 + rng() % 4096;
    std::vector<pixel_tag_t> tags(500);
    for (auto& tag : tags) tag = {.x = rng() % camera.width, .y = rng() % camera.height, .slot = rng() % 256};
    expect_model(camera, tags, GetParam());
  }
}

TEST_F(RayGen, ReachesTheCornersOfFrames) {
  // Steps of one: the components are ahead, a and b themselves.
  for (const auto& [width, height] : {std::array{1, 1}, {7, 5}, {33, 17}, {4096, 4096}, {1, 4096}}) {
    camera_t camera;
    camera.width = static_cast<std::uint64_t>(width);
    camera.height = static_cast<std::uint64_t>(height);
    camera.right = step3(1, 0, 0);
    camera.up = step3(0, 1, 0);
    camera.ahead = step3(0, 0, -7);
    set_port(dut->camera_i, camera);
    const std::uint64_t right = camera.width - 1, bottom = camera.height - 1;
    const auto got = run_stream<pixel_dir_t>(
        dut, std::vector<pixel_tag_t>{{0, 0, 1}, {right, 0, 2}, {0, bottom, 3}, {right, bottom, 4}}, 4);
    ASSERT_EQ(got.size(), 4u);
    for (int corner = 0; corner < 4; ++corner) {
      EXPECT_EQ(got[corner].dir.x, corner % 2 ? width - 1 : 1 - width);
      EXPECT_EQ(got[corner].dir.y, corner / 2 ? 1 - height : height - 1);
      EXPECT_EQ(got[corner].dir.z, -7);
      EXPECT_EQ(got[corner].tag.slot, corner + 1u);
    }
  }
}

TEST_F(RayGen, ReachesTheExtremesOfItsFormat) {
  camera_t camera;
  camera.width = camera.height = 4096;
  const std::int64_t high = (kCompMax - kStepMax) / 4095;  // 4095 high + ahead just fits
  const std::vector<pixel_tag_t> corners = {{0, 0, 0}, {4095, 0, 0}, {0, 4095, 0}, {4095, 4095, 0}};
  camera.right = step3(high, -high, 0);
  camera.ahead = step3(kStepMax, -kStepMax - 1, kStepMax);
  expect_model(camera, corners);
  const dir_t dir = ray_gen(camera, 4095, 0);
  EXPECT_EQ(dir.x, 4095 * high + kStepMax);
  EXPECT_GT(dir.x, kCompMax - 4096);
  EXPECT_LT(dir.y, -kCompMax + 4096);
  // The largest steps wrap, in both alike.
  for (const std::int64_t step : {kStepMax, -kStepMax - 1, std::int64_t{1} << 26, (std::int64_t{1} << 26) - 1, -(std::int64_t{1} << 26)}) {
    camera.right = camera.up = camera.ahead = step3(step, -step - 1, step);
    expect_model(camera, corners);
  }
}

TEST_F(RayGen, FillsEveryStageWhileBlocked) {
  camera_t camera;
  camera.width = camera.height = 64;
  camera.right = step3(12345, -77, 1);
  set_port(dut->camera_i, camera);
  std::vector<pixel_tag_t> taken;
  dut->out_ready_i = 0;
  for (int cycle = 0; cycle < 40; ++cycle) {
    const pixel_tag_t tag = {.x = taken.size(), .y = 3, .slot = 9};
    dut->in_valid_i = cycle % 3 != 1;  // with gaps, which must close up
    set_port(dut->in_i, tag);
    dut.settle();
    if (dut->in_valid_i && dut->in_ready_o) taken.push_back(tag);
    dut.tick();
  }
  EXPECT_EQ(taken.size(), static_cast<std::size_t>(kStages));
  dut->in_valid_i = 0;
  dut->out_ready_i = 1;
  for (const pixel_tag_t& tag : taken) {
    dut.settle();
    ASSERT_TRUE(dut->out_valid_o);
    EXPECT_TRUE(get_port<pixel_dir_t>(dut->out_o) == model(camera, tag));
    dut.tick();
  }
  EXPECT_FALSE(dut->out_valid_o);
}

TEST_F(RayGen, GivesOnePixelACycle) {
  set_port(dut->camera_i, camera_t{});
  const long start = dut.cycles();
  run_stream<pixel_dir_t>(dut, std::vector<pixel_tag_t>(1000), 1000);
  EXPECT_EQ(dut.cycles() - start, 1000 + kStages);
}

}  // namespace
}  // namespace castray::tb
