// SPDX-License-Identifier: Apache-2.0
// The order of a job, each error's code, and the way back to idle from every state.
#include "../mem/test_image.hpp"
#include "Vjob_control.h"
#include "dut.hpp"

namespace castray::tb {

// What the units around it do: how many cycles each takes, and where an error comes from.
struct Surroundings {
  int load = 5, setup = 6, walk = 20, empty = 8, idle = 6;  // idle: behind empty, and behind an abort
  error_t load_error = ErrNone;
};

class JobControl : public testing::Test {
 protected:
  JobControl() {
    dut_->start_i = dut_->read_error_i = dut_->write_error_i = 0;
    dut_->fault_i = 0;
    levels();
    dut_.reset();
    tick();
    reset_before_ = true;
    blocked_before_ = false;
    traffic_until_ = 0;
  }

  // The units' levels now.
  void levels() {
    const auto since = [&](long begun, int takes) { return begun >= 0 && now_ - begun >= takes; };
    dut_->load_done_i = since(load_, around_.load);
    dut_->load_error_i = since(load_, around_.load) ? around_.load_error : junk_error();
    dut_->setup_done_i = since(setup_, around_.setup);
    dut_->walk_done_i = since(walk_, around_.walk);
    dut_->empty_i = !busy_ || since(walk_, around_.walk + around_.empty);
    const bool idle = now_ >= traffic_until_;
    dut_->read_idle_i = idle || (traffic_until_ & 1);
    dut_->write_idle_i = idle || !(traffic_until_ & 1);
  }
  unsigned junk_error() { return static_cast<unsigned>(now_ % 11); }

  void tick() {
    levels();
    dut_.settle();
    if (dut_->load_start_o) log("load"), load_ = now_, busy_ = true;
    if (dut_->setup_start_o) log("setup"), setup_ = now_;
    if (dut_->walk_start_o) log("walk"), walk_ = walked_at_ = now_, traffic_until_ = now_ + around_.walk + around_.empty + around_.idle;
    if (dut_->done_o) log("done"), done_at_ = now_;
    const bool walked = walk_ >= 0;
    if (!dut_->datapath_rst_no) {
      if (!reset_before_) log("clear");
      load_ = setup_ = walk_ = -1;
      busy_ = false;
      ++reset_cycles_;
    }
    if (dut_->block_o && !blocked_before_) log("block"), traffic_until_ = now_ + around_.idle;
    EXPECT_FALSE(dut_->block_o && dut_->datapath_rst_no && dut_->rst_ni);
    reset_before_ = !dut_->datapath_rst_no;
    blocked_before_ = dut_->block_o;
    if (dut_->done_o) {
      EXPECT_TRUE(dut_->running_o);
      EXPECT_TRUE(!walked || (now_ >= traffic_until_ && dut_->empty_i)) << "done before the last response";
      EXPECT_TRUE(dut_->read_idle_i && dut_->write_idle_i);
    }
    dut_.tick();
    ++now_;
  }
  void log(const char* what) { log_ += std::string(log_.empty() ? "" : " ") + what; }

  void start(const job_t& job) {
    set_port(dut_->job_i, job);
    log_.clear();
    done_at_ = -1;
    dut_->start_i = 1;
    tick();
    dut_->start_i = 0;
    EXPECT_TRUE(dut_->running_o);
    EXPECT_EQ(dut_->error_o, ErrNone) << "an old error is shown for a job that runs";
  }
  template <class F> void until(F&& reached) {
    for (int i = 0; i < 400 && !reached(); ++i) tick();
    ASSERT_TRUE(reached());
  }
  // Until done; the error, or -1.
  int finish() {
    for (int i = 0; i < 400 && done_at_ < 0; ++i) tick();
    if (done_at_ < 0) return -1;
    dut_.settle();
    EXPECT_FALSE(dut_->running_o);
    EXPECT_FALSE(dut_->block_o);
    return static_cast<int>(dut_->error_o);
  }
  int run(const job_t& job = TestImage().job) {
    start(job);
    return finish();
  }
  void expect_usable() {
    around_ = {};
    EXPECT_EQ(run(), ErrNone);
    EXPECT_EQ(log_, "load setup walk done clear");
  }

  Dut<Vjob_control> dut_;
  Surroundings around_;
  std::string log_;
  long now_ = 0, load_ = -1, setup_ = -1, walk_ = -1, walked_at_ = -1, done_at_ = -1, traffic_until_ = 0;
  int reset_cycles_ = 0;
  bool busy_ = false, reset_before_ = false, blocked_before_ = false;
};

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
    EXPECT_EQ(log_, defect.error == ErrNone ? "load setup walk done clear" : "done") << defect.name;
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

TEST_F(JobControl, GivesTheLoadersCode) {
  for (int code = 1; code <= 10; ++code) {
    around_.load_error = static_cast<error_t>(code);
    EXPECT_EQ(run(), code);
    EXPECT_EQ(log_, "load clear block done");
  }
  expect_usable();
}

// An error in any cycle from load on: its code; before and after, none at all.
TEST_F(JobControl, EndsTheJobOnAnErrorInAnyCycle) {
  const auto pulse = [&](int source, bool on) {
    dut_->read_error_i = on && source == 0;
    dut_->write_error_i = on && source == 1;
    dut_->fault_i = on && source == 2 ? ErrPrimitive : ErrNone;
  };
  const int codes[] = {ErrReadBus, ErrWriteBus, ErrPrimitive};
  for (int source = 0; source < 3; ++source) {
    int ended = 0;
    for (int at = 0; at < 80; ++at) {
      around_ = {};
      start(TestImage().job);
      bool active = false;
      for (int i = 0; i < at && done_at_ < 0; ++i) tick();
      if (done_at_ < 0) {
        pulse(source, true);
        const std::string before = log_;
        tick();
        active = before.find("load") != std::string::npos || log_.find("load") != std::string::npos;
        active = active && done_at_ < 0;
        pulse(source, false);
      }
      const int error = finish();
      EXPECT_EQ(error, active ? codes[source] : ErrNone) << "source " << source << " at " << at;
      if (active) {
        EXPECT_TRUE(log_.ends_with("clear block done")) << log_;
        ++ended;
      }
    }
    EXPECT_GT(ended, 40);
    expect_usable();
  }
}

TEST_F(JobControl, RanksErrorsOfOneCycle) {
  for (unsigned set = 1; set < 16; ++set) {
    around_.load_error = set & 4 ? ErrSection : ErrNone;
    start(TestImage().job);
    until([&] { return load_ >= 0 && now_ >= load_ + around_.load; });
    dut_->read_error_i = set & 1;
    dut_->write_error_i = set >> 1 & 1;
    dut_->fault_i = set & 8 ? ErrPrimitive : ErrNone;
    tick();
    dut_->read_error_i = dut_->write_error_i = 0;
    dut_->fault_i = 0;
    const int expected = set & 1 ? ErrReadBus : set & 2 ? ErrWriteBus : set & 4 ? ErrSection : ErrPrimitive;
    EXPECT_EQ(finish(), expected) << set;
  }
}

TEST_F(JobControl, KeepsTheFirstError) {
  start(TestImage().job);
  until([&] { return walk_ >= 0; });
  tick();
  dut_->write_error_i = 1;
  tick();
  dut_->write_error_i = 0;
  dut_->read_error_i = 1;
  dut_->fault_i = ErrPrimitive;
  for (int i = 0; i < 3; ++i) tick();
  dut_->read_error_i = 0;
  EXPECT_EQ(finish(), ErrWriteBus);
  dut_->fault_i = 0;
}

TEST_F(JobControl, HoldsTheErrorUntilTheNextStart) {
  around_.load_error = ErrImage;
  EXPECT_EQ(run(), ErrImage);
  for (int i = 0; i < 20; ++i) {
    tick();
    EXPECT_EQ(dut_->error_o, ErrImage);
  }
  expect_usable();
}

// The abort lasts as long as bursts are outstanding, the datapath in reset and the units blocked.
TEST_F(JobControl, AbortsUntilTheBusIsIdle) {
  for (const int idle : {0, 1, 2, 5, 30, 100}) {
    around_.idle = idle;
    start(TestImage().job);
    until([&] { return walk_ >= 0; });
    for (int i = 0; i < 10; ++i) tick();
    dut_->read_error_i = 1;
    tick();
    dut_->read_error_i = 0;
    reset_cycles_ = 0;
    const long from = now_;
    EXPECT_EQ(finish(), ErrReadBus);
    EXPECT_GE(reset_cycles_, std::max(4, idle));
    EXPECT_LE(done_at_ - from, idle + 8);
  }
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
