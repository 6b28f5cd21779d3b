// SPDX-License-Identifier: Apache-2.0
// Start, done, auto restart and the interrupt, by name.
// Unit: axi/axi_lite_regs
#include "lite_regs_bench.hpp"

namespace castray::tb {

TEST_F(AxiLiteRegs, StartStaysUntilDone) {
  write(RegControl, kStart);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(read(RegControl), kStart);
  EXPECT_EQ(starts_, 1);
  finish_job();
  EXPECT_EQ(read(RegControl), kDone | kIdle | kReady);
  wait(10);
  EXPECT_EQ(starts_, 1);
}

TEST_F(AxiLiteRegs, AStartWhileBusyIsIgnored) {
  write(RegControl, kStart);
  wait(3);
  write(RegControl, kStart);
  write(RegControl, kStart);
  finish_job();
  wait(10);
  EXPECT_EQ(starts_, 1);
  EXPECT_EQ(read(RegControl), kDone | kIdle | kReady);
}

TEST_F(AxiLiteRegs, AStartInTheCycleOfDoneIsKept) {
  for (int done_at = 0; done_at < 4; ++done_at) {
    write(RegControl, kStart);
    wait(3);
    const int before = starts_;
    write_beside_done(RegControl, kStart, done_at);
    wait(3);
    const bool kept = done_at <= 1;
    EXPECT_EQ(starts_ - before, kept) << done_at;
    if (kept) finish_job();
    EXPECT_EQ(read(RegControl), kDone | kIdle | kReady);
  }
}

TEST_F(AxiLiteRegs, WritingZeroDoesNotStop) {
  write(RegControl, kStart);
  write(RegControl, 0);
  EXPECT_EQ(read(RegControl), kStart);
}

TEST_F(AxiLiteRegs, DoneAndReadyAreClearedByReading) {
  write(RegControl, kStart);
  finish_job();
  wait(20);
  read(RegIsr);
  EXPECT_EQ(read(RegControl), kDone | kIdle | kReady);
  EXPECT_EQ(read(RegControl), kIdle);
}

// Whenever the job ends, exactly one of the reads around it shows done.
TEST_F(AxiLiteRegs, ADoneInTheCycleOfAReadIsNotLost) {
  for (int at = 0; at < 5; ++at) {
    write(RegControl, kStart);
    int seen = 0;
    dut_->s_axi_arvalid_i = 1;
    dut_->s_axi_araddr_i = RegControl;
    dut_->s_axi_rready_i = 1;
    for (int cycle = 0; cycle < 8; ++cycle) {
      dut_->done_i = cycle == at;
      dut_.settle();
      if (dut_->s_axi_rvalid_o) seen += (dut_->s_axi_rdata_o & kDone) != 0;
      tick();
    }
    dut_->s_axi_arvalid_i = 0;
    dut_.settle();
    if (dut_->s_axi_rvalid_o) seen += (dut_->s_axi_rdata_o & kDone) != 0;
    tick();
    bus_.idle();
    EXPECT_EQ(seen, 1) << at;
  }
}

TEST_F(AxiLiteRegs, AutoRestartTakesTheNewArguments) {
  write(RegFrameSize, 10 | 20 << 16);
  write(RegControl, kStart | kRestart);
  wait(2);
  EXPECT_EQ(read(RegControl), kStart | kRestart);
  EXPECT_EQ(job_.width, 10u);
  write(RegFrameSize, 30 | 40 << 16);
  finish_job();
  wait(3);
  EXPECT_EQ(starts_, 2);
  EXPECT_EQ(job_.width, 30u);
  EXPECT_EQ(read(RegControl), kStart | kDone | kReady | kRestart);
  write(RegControl, 0);  // no further one
  finish_job();
  wait(10);
  EXPECT_EQ(starts_, 2);
  EXPECT_EQ(read(RegControl), kDone | kIdle | kReady);
}

TEST_F(AxiLiteRegs, AnIsrBitIsSetOnlyIfEnabled) {
  for (unsigned ier = 0; ier < 4; ++ier) {
    write(RegIer, ier);
    write(RegControl, kStart);
    finish_job();
    EXPECT_EQ(read(RegIsr), ier);
    write(RegIsr, ier);
    EXPECT_EQ(read(RegIsr), 0u);
  }
}

TEST_F(AxiLiteRegs, WritingIsrToggles) {
  write(RegIsr, 2);
  EXPECT_EQ(read(RegIsr), 2u);
  write(RegIsr, 3);
  EXPECT_EQ(read(RegIsr), 1u);
  write(RegIsr, 0);
  EXPECT_EQ(read(RegIsr), 1u);
  write(RegIsr, 1);
  EXPECT_EQ(read(RegIsr), 0u);
}

TEST_F(AxiLiteRegs, AnEndInTheCycleOfAToggleSetsIsr) {
  write(RegIer, 1);
  for (int at = 0; at < 4; ++at) {
    write(RegControl, kStart);
    wait(2);
    write_beside_done(RegIsr, 1, at);
    // An end before the write is toggled away, one with it or after it stays set (it was toggled to
    // one before).
    EXPECT_EQ(read(RegIsr), at == 0 ? 0u : 1u) << at;
    if (at != 0) write(RegIsr, 1);
  }
}

TEST_F(AxiLiteRegs, TheInterruptIsGieAndAnyIsr) {
  write(RegIer, 3);
  write(RegControl, kStart);
  finish_job();
  wait(3);
  EXPECT_FALSE(dut_->interrupt_o);
  EXPECT_EQ(read(RegControl) & kInterrupt, 0u);
  write(RegGie, 1);
  EXPECT_TRUE(dut_->interrupt_o);
  EXPECT_NE(read(RegControl) & kInterrupt, 0u);
  write(RegIsr, 1);
  EXPECT_TRUE(dut_->interrupt_o) << "the other bit is still set";
  write(RegIsr, 2);
  EXPECT_FALSE(dut_->interrupt_o);
}

}  // namespace castray::tb
