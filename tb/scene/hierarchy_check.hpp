// SPDX-License-Identifier: Apache-2.0
// In the model: a ray through the hierarchy hits what it hits by brute force, bit for bit; any hit is found
// exactly where there is one. And a frame, with the start of its tiles.
#pragma once
#include <gtest/gtest.h>

#include "core.hpp"
#include "ray_maker.hpp"
#include "traverse/lane.hpp"

namespace castray::tb {

struct Totals {
  long rays = 0, hits = 0, any_hits = 0, nodes = 0, tests = 0;
};

class Hierarchy {
 public:
  Hierarchy(const SceneImage& image, unsigned seed)
      : maker_(image, seed), tree_{.image = image.bytes.data(), .header = &image.header, .limit = 10000000} {}

  // Also with limits around the hit, and without the primitive hit.
  void run(int rays) {
    for (int i = 0; i < rays; ++i) {
      const ray_t ray = maker_.make();
      const hit_t hit = expect_same(ray);
      if (testing::Test::HasFailure()) return;
      if (hit.found && maker_.one_in(2)) expect_same(maker_.around(ray, hit.t, hit.number));
    }
  }
  Totals totals;

 private:
  hit_t expect_same(const ray_t& ray) {
    const auto ignore = [](const cand_t&, const result_t*) {};
    std::uint64_t tests = 0;
    const hit_t brute = lane(ray, maker_.slots(), tests, ignore);
    const TreeHit tree = lane(ray, tree_, tree_.root(), ignore);
    EXPECT_EQ(tree.error, ErrNone) << to_text(ray);
    if (ray.any_hit) EXPECT_EQ(tree.hit.found, brute.found) << to_text(ray);
    else if (!(tree.hit == brute)) ADD_FAILURE() << to_text(ray) << "\n" << to_text(tree.hit) << "\nbrute force " << to_text(brute);
    EXPECT_LE(tree.work.tests, tests);
    ++totals.rays;
    totals.hits += static_cast<long>(brute.found);
    totals.any_hits += brute.found && ray.any_hit;
    totals.nodes += static_cast<long>(tree.work.nodes), totals.tests += static_cast<long>(tree.work.tests);
    return brute;
  }
  RayMaker maker_;
  Tree tree_;
};

// The hit records of an image's frame.
inline std::vector<std::uint8_t> frame_hits(const SceneImage& image, bool brute) {
  const frame_record_t& record = image.frame;
  std::vector<std::uint8_t> frame(record.stride * record.height), hits(record.width * record.height * HitBytes);
  job_t job;
  job.image_bytes = image.bytes.size(), job.frame_bytes = frame.size(), job.hits_bytes = hits.size();
  job.width = job.x1 = record.width, job.height = job.y1 = record.height;
  job.want_hits = 1, job.brute = brute, job.steps = 1 << 20;
  EXPECT_EQ(run_job(job, {.image = image.bytes, .frame = frame, .hits = hits}).error, ErrNone);
  return hits;
}
inline void expect_same_frame(const SceneImage& image) { EXPECT_TRUE(frame_hits(image, false) == frame_hits(image, true)) << "a frame's hits differ"; }

}  // namespace castray::tb
