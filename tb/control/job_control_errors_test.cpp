// SPDX-License-Identifier: Apache-2.0
// Each error's code, which of several counts, and the abort that follows.
// Unit: control/job_control
#include "job_control_bench.hpp"

namespace castray::tb {

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

}  // namespace castray::tb
