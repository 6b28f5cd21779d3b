// SPDX-License-Identifier: Apache-2.0
// Rays in scene units as records, and a record's t as a distance.
#include "scene/ray_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "mem/ray_request.hpp"
#include "reference/pixel_ray.hpp"
#include "scene/load.hpp"

namespace castray {
namespace {

// A sphere of radius 1 about the world's origin, rays from -3 to 3: steps of 2^-23.
struct RayRecord : testing::Test {
  RayRecord() {
    scene.spheres.push_back({});
    const ListRay ends[] = {{.origin = Vec3(-3)}, {.origin = Vec3(3)}};
    image = compile(scene, ends);
    EXPECT_EQ(image.header.grid_power, -23);
  }
  ray_record_t record(ListRay ray) const {
    if (ray.direction == Vec3(0)) ray.direction = Vec3(1, 0, 0);
    return ray_record(image, ray);
  }
  Scene scene;
  SceneImage image;
};

TEST_F(RayRecord, OriginsGoToTheNearestStep) {
  const Grid grid = image.grid();
  const double step = image.step();
  const ray_record_t r = record({.origin = Vec3(-3, 1 + 0.4 * step, 3 - 0.4 * step)});
  EXPECT_EQ(r.org_x, 32u) << "the lowest origin";
  EXPECT_EQ(r.org_y, static_cast<std::uint64_t>((1 << 23) - grid.corner[1]));
  EXPECT_EQ(r.org_z, static_cast<std::uint64_t>((3 << 23) - grid.corner[2]));
}

TEST_F(RayRecord, DirectionsFillTheirFormatWhateverTheirLength) {
  for (const double scale : {1.0, 0x1p-1000, 0x1p1000, 0x1p-40}) {
    const ray_record_t r = record({.direction = Vec3(0.75, -1.5, 0x1p-30) * scale});
    EXPECT_EQ(r.dir_x, std::int64_t{3} << 40);
    EXPECT_EQ(r.dir_y, -(std::int64_t{3} << 41));
    EXPECT_EQ(r.dir_z, std::int64_t{1} << 12);
  }
  EXPECT_EQ(record({.direction = Vec3(0, 0, 5e-324)}).dir_z, std::int64_t{1} << 42);
  // Rounded up to 2, which the format holds.
  const double largest = std::nextafter(2.0, 0.0);
  EXPECT_EQ(record({.direction = Vec3(-largest, largest, 1)}).dir_y, std::int64_t{1} << 43);
  EXPECT_EQ(record({.direction = Vec3(-largest, largest, 1)}).dir_x, -(std::int64_t{1} << 43));
}

TEST_F(RayRecord, RangesAreAlongTheDominantAxis) {
  const auto t = [](double steps) { return static_cast<std::int64_t>(steps * 16); };
  const ray_record_t straight = record({.direction = Vec3(0, 0, -7), .tmin = 0.5, .tmax = 2});
  EXPECT_EQ(straight.tmin, t(0x1p22));
  EXPECT_EQ(straight.tmax, t(0x1p24));
  const ray_record_t slanted = record({.direction = Vec3(0, 3, 4), .tmin = 1.25, .tmax = 2.5});
  EXPECT_EQ(slanted.tmin, t(0x1p23));
  EXPECT_EQ(slanted.tmax, t(0x1p24));
  EXPECT_EQ(record({.tmin = 0.6 * image.step() / 16}).tmin, 1);
  EXPECT_EQ(record({.tmin = 0.4 * image.step() / 16}).tmin, 0);
}

TEST_F(RayRecord, RangesBeyondTheGridEndWithIt) {
  const ray_record_t open = record({});
  EXPECT_EQ(open.tmin, 0);
  EXPECT_EQ(open.tmax, TMax);
  EXPECT_EQ(record({.tmin = -5, .tmax = 100}).tmin, 0);
  EXPECT_EQ(record({.tmin = -5, .tmax = 100}).tmax, TMax);
  EXPECT_EQ(record({.tmin = 1e308}).tmin, TMax);
}

TEST_F(RayRecord, FlagsAndIgnoredPrimitives) {
  EXPECT_EQ(record({}).flags, 0u);
  EXPECT_EQ(record({.any = true}).flags, 1u << RayAnyHit);
  EXPECT_EQ(record({.cull = true}).flags, 1u << RayCull);
  EXPECT_EQ(record({.ignore = 0}).ignore, 0u);
  EXPECT_EQ(record({}).ignore, std::uint64_t{NoHit});
  EXPECT_TRUE(ray_request(record({}), 0).ok);
}

TEST_F(RayRecord, DistancesAreThoseOfTheRay) {
  EXPECT_EQ(ray_distance(image, {.direction = Vec3(0, 0, -7)}, 16 << 23), 1);
  EXPECT_EQ(ray_distance(image, {.direction = Vec3(0, -3, 4) * 0x1p-1060}, 16 << 23), 1.25);
  EXPECT_EQ(ray_distance(image, {.direction = Vec3(3, 4, 0) * 1e300}, 1), 1.25 * 0x1p-27);
}

// So a hit's distance, taken as the tmin of the next ray, leaves that hit out.
TEST_F(RayRecord, ADistanceReadsBackAsItsT) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> side(-1, 1);
  for (int i = 0; i < 100'000; ++i) {
    const ListRay ray{.direction = Vec3(side(random), side(random), side(random))};
    const auto t = static_cast<std::int64_t>(random() % TMax);
    ListRay next = ray;
    next.tmin = ray_distance(image, ray, t);
    ASSERT_EQ(ray_record(image, next).tmin, t);
  }
}

TEST(RayRecordOfACamera, ShearsAreTheFramesButForTheLastBit) {
  const Scene scene = load_scene("scenes/teapot.json");
  const SceneImage image = compile(scene, 320, 240);
  const camera_t camera = frame_setup(image.frame);
  for (int y = 0; y < 240; y += 7)
    for (int x = 0; x < 320; x += 7) {
      const ray_record_t record = ray_record(image, {.origin = scene.camera.eye(), .direction = pixel_direction(scene, 320, 240, x, y)});
      const ray_t listed = ray_setup(ray_request(record, 0)), framed = ray_setup(ray_gen(camera, x, y), camera, {});
      ASSERT_EQ(listed.axis, framed.axis);
      EXPECT_EQ(listed.neg, framed.neg);
      EXPECT_EQ(to_text(listed.org), to_text(framed.org));
      EXPECT_LE(std::abs(listed.sx - framed.sx), 1);
      EXPECT_LE(std::abs(listed.sy - framed.sy), 1);
    }
}

}  // namespace
}  // namespace castray
