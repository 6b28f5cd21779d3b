// SPDX-License-Identifier: Apache-2.0
// The job control with the units around it played by the test, and a log of what it asks of them.
#pragma once
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

}  // namespace castray::tb
