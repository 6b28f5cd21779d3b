// SPDX-License-Identifier: Apache-2.0
// The order of a job, what it waits for, its arguments, and the way back to idle from every state.
#include "job_control_bench.hpp"

namespace castray::tb {

TEST_F(JobControl, GoesThroughItsStepsInOrder) {
  for (int i = 0; i < 3; ++i) expect_usable();
}

TEST_F(JobControl, WaitsForEachUnit) {
  for (int takes : {1, 2, 3, 7, 50}) {
    around_ = {takes, takes, takes, takes, takes, ErrNone};
    EXPECT_EQ(run(), ErrNone) << takes;
    EXPECT_EQ(log_, "load setup walk done clear") << takes;
    EXPECT_GE(done_at_, walked_at_ + 3 * takes);
    EXPECT_LE(done_at_, walked_at_ + 3 * takes + 8);
  }
}

// Whichever level is last, and though another flickers, done comes four quiet cycles after it.
TEST_F(JobControl, DrainsUntilAllHasBeenQuietForAWhile) {
  for (int empty = 0; empty < 12; ++empty) {
    for (int idle = 0; idle < 12; ++idle) {
      around_ = {1, 1, 10, empty, idle, ErrNone};
      EXPECT_EQ(run(), ErrNone);
      EXPECT_EQ(done_at_, walked_at_ + 10 + empty + idle + 4) << empty << " " << idle;
    }
  }
}

TEST_F(JobControl, HoldsTheDatapathInResetBetweenJobs) {
  EXPECT_EQ(run(), ErrNone);
  reset_cycles_ = 1;  // that of done
  start(TestImage().job);
  EXPECT_FALSE(dut_->datapath_rst_no);
  until([&] { return load_ >= 0; });
  EXPECT_EQ(reset_cycles_, 4);
  EXPECT_EQ(finish(), ErrNone);
}

TEST_F(JobControl, HoldsTheDatapathInResetWhileIdle) {
  EXPECT_FALSE(dut_->datapath_rst_no);
  EXPECT_EQ(run(), ErrNone);
  for (int i = 0; i < 30; ++i) {
    tick();
    EXPECT_FALSE(dut_->datapath_rst_no);
  }
}

TEST_F(JobControl, JudgesArgumentsAsTheModel) {
  for (const Defect& defect : kJobDefects) {
    TestImage image;
    defect.spoil(image);
    EXPECT_EQ(check_job(image.job), defect.error) << "the model: " << defect.name;
    EXPECT_EQ(run(image.job), defect.error) << defect.name;
    EXPECT_EQ(log_, defect.error != ErrNone ? "done" : image.job.is_list ? "load walk done clear" : "load setup walk done clear") << defect.name;
  }
  expect_usable();
}

TEST_F(JobControl, JudgesSeededArgumentsAsTheModel) {
  std::mt19937_64 rng(9);
  int bad = 0;
  around_ = {1, 1, 1, 0, 0, ErrNone};
  for (int round = 0; round < 20000; ++round) {
    job_t job = TestImage().job;
    const auto near = [&](std::uint64_t value, std::uint64_t mask) { return (value + rng() % 3 - 1) & mask; };
    job.width = rng() % 3 ? 1 + rng() % 4096 : near(4096, 0x1fff);
    job.height = rng() % 3 ? 1 + rng() % 4096 : near(0, 0x1fff);
    job.x1 = rng() % 2 ? job.width : near(job.width, 0x1fff);
    job.y1 = rng() % 2 ? job.height : near(job.height, 0x1fff);
    job.x0 = rng() % 2 ? rng() % (job.x1 + 1) : near(job.x1, 0x1fff);
    job.y0 = rng() % 2 ? 0 : near(job.y1, 0x1fff);
    job.want_hits = rng() & 1;
    job.is_list = rng() % 4 == 0;
    job.ray_count = rng() % 3 ? 1 + rng() % MaxRays : near(rng() % 2 ? MaxRays : 0, 0x1ffffff);
    job.ray_bytes = rng() & 0xffffffff;
    job.rays = rng() % 4 ? rng() % (kSpace >> 8) * 64 : (kSpace - job.ray_bytes - 128 + 64 * (rng() % 4)) & ~63ull;
    if (rng() % 4 == 0) job.frame = kSpace - job.frame_bytes - 128 + 64 * (rng() % 4);
    if (rng() % 4 == 0) job.hits = (kSpace - job.hits_bytes - 128 + 64 * (rng() % 4)) & ~63ull;
    if (rng() % 8 == 0) job.image += 1ull << rng() % 10;
    job.image_bytes = rng() % 8 ? job.image_bytes : near(256, 0xffffffff);
    const error_t expected = check_job(job);
    bad += expected != ErrNone;
    ASSERT_EQ(run(job), expected) << to_text(job);
  }
  EXPECT_GT(bad, 4000);
  EXPECT_LT(bad, 18000);
}

TEST_F(JobControl, IsUsableAfterAResetInAnyCycle) {
  for (int cut = 0; cut < 70; ++cut) {
    for (const bool bad : {false, true}) {
      around_ = {};
      around_.load_error = bad ? ErrSection : ErrNone;
      start(TestImage().job);
      for (int i = 0; i < cut; ++i) tick();
      dut_.reset(1);
      load_ = setup_ = walk_ = done_at_ = -1;
      traffic_until_ = 0;
      busy_ = false;
      tick();
      tick();
      EXPECT_FALSE(dut_->running_o);
      EXPECT_EQ(dut_->error_o, ErrNone);
      expect_usable();
    }
  }
}

}  // namespace castray::tb
