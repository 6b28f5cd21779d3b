// SPDX-License-Identifier: Apache-2.0
// Lists of rays in the model, through the driver: the camera's rays are the frame's, and what no list is.
#include <gtest/gtest.h>

#include "camera_list.hpp"
#include "frame_run.hpp"
#include "model_device.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

using sim::camera_rays;

TEST(Query, TheCamerasRaysGiveTheFramesHits) {
  const SceneImage image = compile(load_scene("scenes/spheres.json"), 60, 40);
  const auto rays = sim::bytes_of(camera_rays(image));
  for (const sim::Mode mode : {sim::Mode::kBvhRoot, sim::Mode::kBrute}) {
    const sim::Rendering frame = sim::run_model(image, {.mode = mode});
    const sim::Answers answers = sim::query_model(image, rays, {.mode = mode});
    ASSERT_EQ(answers.error, ErrNone);
    EXPECT_TRUE(answers.hits == frame.hits);
    for (const auto counter : {CntTests, CntRays, CntHits, CntCandidates, CntNodes})
      EXPECT_EQ(answers.counters[static_cast<std::size_t>(counter)], frame.counters[static_cast<std::size_t>(counter)]) << counter;
  }
}

TEST(Query, AnyHitSaysYesWhereANearestHitIs) {
  const SceneImage image = compile(load_scene("scenes/spheres.json"), 60, 40);
  std::vector<ray_record_t> rays = camera_rays(image);
  const sim::Answers nearest = sim::query_model(image, sim::bytes_of(rays));
  for (ray_record_t& ray : rays) ray.flags = 1u << RayAnyHit;
  const sim::Answers any = sim::query_model(image, sim::bytes_of(rays));
  ASSERT_EQ(any.size(), nearest.size());
  for (std::size_t i = 0; i < any.size(); ++i) {
    const bool hit = nearest.hit(i).prim != static_cast<std::uint64_t>(NoHit);
    EXPECT_EQ(any.hit(i).prim, static_cast<std::uint64_t>(hit ? AnyHit : NoHit));
    EXPECT_EQ(any.hit(i).t, hit ? 0 : TMax);
  }
  EXPECT_LT(any.counters[CntNodes], nearest.counters[CntNodes]) << "it ends at the first";
}

TEST(Query, ListsThatAreNone) {
  const SceneImage image = compile(load_scene("scenes/cube.geo"), 8, 8);
  sim::ModelDevice device;
  sim::Driver driver(device);
  driver.load(image);
  EXPECT_THROW(driver.query({}), std::invalid_argument);
  EXPECT_THROW(driver.query(std::vector<std::uint8_t>(65)), std::invalid_argument);
  std::vector<ray_record_t> rays = camera_rays(image);
  rays[17].flags = 4;
  EXPECT_EQ(driver.query(sim::bytes_of(rays)).error, ErrRay);
  rays[17].flags = 0;
  EXPECT_EQ(driver.query(sim::bytes_of(rays)).error, ErrNone);
}

}  // namespace
}  // namespace castray::tb
