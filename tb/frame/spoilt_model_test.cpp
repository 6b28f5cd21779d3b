// SPDX-License-Identifier: Apache-2.0
// Spoilt scene images in the model, in each mode, in memory that ends with its windows: every job ends, with an
// error of those that its rays and tiles have or with a picture, and touches nothing outside.
// Long: CASTRAY_IMAGES=10000
#include <gtest/gtest.h>

#include <cstdio>

#include "core.hpp"
#include "frame/guarded_bytes.hpp"
#include "frame/spoilt_list.hpp"

namespace castray::tb {
namespace {

constexpr std::uint8_t kUntouched = 0xa5;

job_t job_of(const Spoilt& spoilt, unsigned mode, bool hits) {
  const frame_record_t& frame = spoilt.image.frame;
  job_t job;
  job.image = 0x1'0000'0000, job.frame = 0x2'0000'0000, job.hits = 0x3'0000'0000;
  job.image_bytes = spoilt.window;
  job.frame_bytes = frame.stride * frame.height;
  job.hits_bytes = hits ? frame.width * frame.height * HitBytes : 0;
  job.width = job.x1 = frame.width, job.height = job.y1 = frame.height;
  job.want_hits = hits;
  job.brute = mode == 0, job.from_root = mode == 1;
  job.steps = spoilt.steps == 0 ? (1u << 24) - 1 : spoilt.steps;
  return job;
}

// Runs the job twice: as it is, and on behind errors.
error_t expect_an_end(const job_t& job, const Windows& windows, unsigned& several) {
  const Outcome outcome = run_job(job, windows, {.threads = 1});
  const Outcome all = run_job(job, windows, {.threads = 1, .every_error = true});
  EXPECT_EQ(outcome.error == ErrNone, all.errors == 0);
  EXPECT_EQ(outcome.error, all.error);
  if (outcome.error != ErrNone) EXPECT_TRUE(all.errors >> outcome.error & 1);
  several += (all.errors & (all.errors - 1)) != 0;
  return outcome.error;
}

TEST(SpoiltImages, EndEveryListOfTheModelInsideItsWindows) {
  const unsigned count = images_to_spoil(450);
  SpoiltCounts counts;
  unsigned several = 0;
  for (unsigned seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    const Spoilt spoilt = Spoiler(seed).make();
    const std::vector<std::uint8_t> list = rays_for(spoilt, seed);
    for (const unsigned mode : {0u, 1u}) {
      SCOPED_TRACE(spoilt.text + ", " + (mode == 0 ? "brute" : "bvh_root"));
      job_t job = job_of(spoilt, mode, true);
      job.is_list = 1;
      job.rays = 0x4'0000'0000, job.ray_count = list.size() / RayBytes, job.ray_bytes = list.size();
      job.hits_bytes = job.ray_count * HitBytes;
      GuardedBytes image(spoilt.window), rays(list.size()), hits(job.hits_bytes);
      image.fill(std::span(spoilt.image.bytes).first(spoilt.window));
      rays.fill(list);
      counts.count(seed, expect_an_end(job, {.image = image.span(), .frame = {}, .hits = hits.span(), .rays = rays.span()}, several));
    }
  }
  std::printf("%u images, %u lists: %u end well, %u have more than one error\n", count, counts.total(), counts.of(ErrNone), several);
  for (const error_t error : {ErrRegister, ErrImage, ErrSection, ErrPrimitive, ErrNode, ErrLeaf, ErrStack, ErrSteps, ErrRay})
    EXPECT_GE(counts.of(error), count / 1000) << "too few of error " << error;
}

TEST(SpoiltImages, EndEveryJobOfTheModelInsideItsWindows) {
  const unsigned count = images_to_spoil(450);
  SpoiltCounts counts;
  unsigned several = 0;
  for (unsigned seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    const Spoilt spoilt = Spoiler(seed).make();
    const char* const modes[] = {"brute", "bvh_root", "bvh"};
    for (unsigned mode = 0; mode < 3; ++mode) {
      SCOPED_TRACE(spoilt.text + ", " + modes[mode]);
      const job_t job = job_of(spoilt, mode, seed % 3 != 0);
      GuardedBytes image(spoilt.window), frame(job.frame_bytes), hits(job.hits_bytes);
      image.fill(std::span(spoilt.image.bytes).first(spoilt.window));
      std::ranges::fill(frame.span(), kUntouched);
      counts.count(seed, expect_an_end(job, {.image = image.span(), .frame = frame.span(), .hits = hits.span(), .rays = {}}, several));
    }
  }
  std::printf("%u images, %u jobs: %u end well, %u have more than one error\n", count, counts.total(), counts.of(ErrNone), several);
  for (const error_t error : {ErrRegister, ErrImage, ErrParameters, ErrSection, ErrFrameRecord, ErrFrameWindow, ErrPrimitive, ErrNode, ErrLeaf, ErrStack, ErrSteps}) {
    std::printf("  %5u  %s\n", counts.of(error), meaning(error));
    EXPECT_GE(counts.of(error), count / 1000) << "too few of error " << error;
  }
}

}  // namespace
}  // namespace castray::tb
