// SPDX-License-Identifier: Apache-2.0
// What tests of lists of rays share: lists of random rays and of a camera's, and their comparison.
#pragma once
#include "../scene/ray_maker.hpp"
#include "camera_list.hpp"
#include "frame/frame.hpp"

namespace castray::tb {

using sim::camera_rays;

inline bool is_yes(const hit_record_t& record) { return record.prim != static_cast<std::uint64_t>(NoHit); }

// Random rays in an image, each way to be no ray among them; the second half around hits of the first.
inline std::vector<ray_record_t> random_rays(const SceneImage& image, std::size_t count, unsigned seed) {
  RayMaker maker(image, seed);
  std::mt19937_64 rng(seed + 77);
  std::vector<ray_record_t> rays;
  while (rays.size() < (count + 1) / 2) {
    rays.push_back(maker.record());
    ray_record_t& ray = rays.back();
    switch (rng() % 60) {
      case 0: ray.dir_x = ray.dir_y = ray.dir_z = 0; break;
      case 1: ray.org_y = (std::uint64_t{1} << CoordW) + rng() % 1000; break;
      case 2: ray.dir_z = static_cast<std::int64_t>(rng()) | std::int64_t{1} << 50; break;
      case 3: ray.tmax = ray.tmin; break;
    }
  }
  const sim::Answers first = sim::query_model(image, sim::bytes_of(rays));
  for (std::size_t i = 0; rays.size() < count; ++i) {
    const hit_record_t hit = first.hit(i);
    rays.push_back(is_yes(hit) && hit.prim != static_cast<std::uint64_t>(AnyHit) ? maker.around(rays[i], hit.t, hit.prim) : maker.record());
  }
  return rays;
}

// True if nothing differs.
inline testing::AssertionResult equal(const sim::Answers& a, const sim::Answers& b, const std::vector<ray_record_t>& rays) {
  if (a.error != ErrNone || b.error != ErrNone) return testing::AssertionFailure() << meaning(a.error) << "; " << meaning(b.error);
  const sim::Comparison comparison = sim::compare(a, b);
  if (comparison.equal()) return testing::AssertionSuccess();
  auto failure = testing::AssertionFailure() << comparison.hits_differ << " of " << rays.size() << " records differ";
  for (const std::size_t i : comparison.first)
    failure << "\n  ray " << i << ": " << to_text(rays[i]) << "\n    " << to_text(a.hit(i)) << "\n    " << to_text(b.hit(i));
  return failure;
}

// Any-hit rays say yes exactly where, asked for the nearest, they hit.
inline void expect_any_is_nearest(const SceneImage& image, std::vector<ray_record_t> rays, const sim::Answers& answers) {
  const std::vector<ray_record_t> asked = rays;
  for (ray_record_t& ray : rays) ray.flags &= ~(std::uint64_t{1} << RayAnyHit);
  const sim::Answers nearest = sim::query_model(image, sim::bytes_of(rays));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (asked[i].flags >> RayAnyHit & 1)
      ASSERT_EQ(answers.hit(i).prim, static_cast<std::uint64_t>(is_yes(nearest.hit(i)) ? AnyHit : NoHit)) << i << ": " << to_text(asked[i]);
    else
      ASSERT_TRUE(answers.hit(i) == nearest.hit(i)) << i;
  }
}

// The core's answers to a list, in either mode, are the model's, whose modes agree.
inline void expect_list(Core& core, const SceneImage& image, const std::vector<ray_record_t>& rays) {
  const std::vector<std::uint8_t> bytes = sim::bytes_of(rays);
  core.driver.load(image);
  sim::Answers tree;
  for (const sim::Mode mode : {sim::Mode::kBvhRoot, sim::Mode::kBrute}) {
    const sim::Answers model = sim::query_model(image, bytes, {.mode = mode}), rtl = core.driver.query(bytes, {.mode = mode});
    ASSERT_TRUE(equal(rtl, model, rays)) << sim::kModeNames[static_cast<std::size_t>(mode)];
    EXPECT_TRUE(equal(rtl.counters, model.counters));
    EXPECT_TRUE(kept_the_rules(core.device));
    if (mode == sim::Mode::kBrute) ASSERT_TRUE(equal(model, tree, rays)) << "brute force and the hierarchy";
    tree = model;
  }
}

}  // namespace castray::tb
