// SPDX-License-Identifier: Apache-2.0
// Each rule of the register map, by name: accesses, arguments, and the job that is made of them.
// Verilator: -GLanes=5 -GContexts=33 -GTileLog2=4
#include "lite_regs_bench.hpp"

namespace castray::tb {

TEST_F(AxiLiteRegs, AreZeroAndIdleAfterReset) {
  EXPECT_EQ(read(RegControl), kIdle);
  for (const std::int64_t offset : {RegGie, RegIer, RegIsr, RegError}) EXPECT_EQ(read(offset), 0u) << offset;
  for (const std::int64_t offset : kArguments) EXPECT_EQ(read(offset), 0u) << offset;
  EXPECT_FALSE(dut_->interrupt_o);
}

TEST_F(AxiLiteRegs, ShowVersionConfigAndParameters) {
  EXPECT_EQ(read(RegVersion), VersionMajor << 16 | VersionMinor << 8 | VersionPatch);
  EXPECT_EQ(read(RegConfig), 5u | 33u << 8 | 16u << 16);
  EXPECT_EQ(read(RegParameters), static_cast<std::uint32_t>(ImageParameters));
}

TEST_F(AxiLiteRegs, KeepArgumentsApart) {
  std::uint32_t value = 0x9e3779b9;
  for (const std::int64_t offset : kArguments) write(offset, value += 0x7f4a7c15);
  value = 0x9e3779b9;
  for (const std::int64_t offset : kArguments) EXPECT_EQ(read(offset), value += 0x7f4a7c15) << offset;
}

TEST_F(AxiLiteRegs, HonourByteStrobes) {
  for (const std::int64_t offset : kArguments) {
    for (unsigned strb = 0; strb < 16; ++strb) {
      write(offset, 0x11223344);
      write(offset, 0xaabbccdd, strb);
      std::uint32_t expected = 0;
      for (unsigned i = 0; i < 4; ++i) expected |= ((strb >> i & 1 ? 0xaabbccddu : 0x11223344u) & 0xffu << 8 * i);
      EXPECT_EQ(read(offset), expected) << offset << " strobes " << strb;
    }
  }
}

TEST_F(AxiLiteRegs, IgnoreControlWritesWithoutTheLowByte) {
  write(RegControl, kStart | kRestart, 14);
  write(RegGie, 1, 14);
  write(RegIer, 3, 14);
  write(RegIsr, 3, 14);
  wait(4);
  EXPECT_EQ(starts_, 0);
  EXPECT_EQ(read(RegControl), kIdle);
  for (const std::int64_t offset : {RegGie, RegIer, RegIsr}) EXPECT_EQ(read(offset), 0u) << offset;
}

TEST_F(AxiLiteRegs, UndefinedOnesReadZeroAndTakeWrites) {
  std::vector<bool> defined(1u << RegAddrW);
  for (const std::int64_t offset : kArguments) defined[offset] = true;
  for (const std::int64_t offset : {RegControl, RegGie, RegIer, RegIsr, RegVersion, RegConfig, RegParameters, RegError})
    defined[offset] = true;
  for (int i = 0; i < Counters; ++i) defined[RegCounters + 8 * i] = defined[RegCounters + 8 * i + 4] = true;
  counts_.fill(~0ull);
  for (unsigned offset = 0; offset < 1u << RegAddrW; offset += 4) {
    if (defined[offset]) continue;
    write(offset, 0xffffffff);
    EXPECT_EQ(read(offset), 0u) << offset;
  }
  EXPECT_EQ(read(RegControl), kIdle);
  for (const std::int64_t offset : kArguments) EXPECT_EQ(read(offset), 0u) << offset;
}

TEST_F(AxiLiteRegs, DoNotWriteReadOnlyOnes) {
  for (const std::int64_t offset : {RegVersion, RegConfig, RegParameters, RegError, RegCounters}) {
    const std::uint32_t before = read(offset);
    write(offset, ~before);
    EXPECT_EQ(read(offset), before) << offset;
  }
}

TEST_F(AxiLiteRegs, HaveOneBitForGieAndTwoForIer) {
  write(RegGie, 0xffffffff);
  write(RegIer, 0xffffffff);
  EXPECT_EQ(read(RegGie), 1u);
  EXPECT_EQ(read(RegIer), 3u);
}

TEST_F(AxiLiteRegs, ShowCountersAndError) {
  for (unsigned i = 0; i < Counters; ++i) counts_[i] = 0x1234567800000000ull * (i + 1) + 77 * i + 5;
  for (unsigned i = 0; i < Counters; ++i) {
    const std::uint64_t low = read(RegCounters + 8 * i), high = read(RegCounters + 8 * i + 4);
    EXPECT_EQ(low | high << 32, 0x1234567800000000ull * (i + 1) + 77 * i + 5);
  }
  dut_->error_i = ErrHitWindow;
  EXPECT_EQ(read(RegError), ErrHitWindow);
}

TEST_F(AxiLiteRegs, TakeAddressAndDataInAnyOrder) {
  std::uint32_t value = 1;
  for (int address = 0; address < 4; ++address) {
    for (int data = 0; data < 4; ++data) {
      for (int response = 0; response < 3; ++response) {
        bus_.write(RegHits, ++value, 15, {address, data, response});
        EXPECT_EQ(bus_.read(RegHits, {address, 0, response}), value);
      }
    }
  }
}

// No path from a ready input to a valid output, nor back.
TEST_F(AxiLiteRegs, HandshakesAreIndependent) {
  dut_->s_axi_arvalid_i = 1;
  dut_->s_axi_araddr_i = 0;
  dut_->s_axi_awvalid_i = dut_->s_axi_wvalid_i = 1;
  dut_->s_axi_awaddr_i = RegHits;
  dut_->s_axi_bready_i = dut_->s_axi_rready_i = 0;
  for (int cycle = 0; cycle < 4; ++cycle) {
    dut_.settle();
    const bool b = dut_->s_axi_bvalid_o, r = dut_->s_axi_rvalid_o;
    dut_->s_axi_bready_i = dut_->s_axi_rready_i = 1;
    dut_.settle();
    EXPECT_EQ(dut_->s_axi_bvalid_o, b);
    EXPECT_EQ(dut_->s_axi_rvalid_o, r);
    dut_->s_axi_bready_i = dut_->s_axi_rready_i = 0;
    tick();
  }
  EXPECT_TRUE(dut_->s_axi_bvalid_o && dut_->s_axi_rvalid_o) << "answers wait";
}

TEST_F(AxiLiteRegs, LatchTheJobAtItsStart) {
  std::mt19937 rng(3);
  for (int round = 0; round < 300; ++round) {
    for (const std::int64_t offset : kArguments) {
      std::uint32_t value = static_cast<std::uint32_t>(rng());
      const int kind = static_cast<int>(rng() % 4);
      if (kind != 0) value &= offset == RegOptions ? (1u << NumOptions) - 1
                             : offset == RegSteps    ? 0xffffff
                             : offset == RegRayCount ? 0x1ffffff
                             : offset >= RegFrameSize && offset <= RegWindowMax ? 0x1fff1fff
                                                                                : 0xffffff00;
      if (offset == RegOptions && rng() % 4 != 0) value &= ~(1u << OptionWork);
      if (kind != 0 && (offset == RegImage + 4 || offset == RegFrame + 4 || offset == RegHits + 4 || offset == RegRays + 4)) value >>= 24;
      if (kind == 1 && (offset == RegWindowMax || offset == RegSteps)) value = 0;
      write(offset, value);
    }
    const job_t expected = model_job();
    write(RegControl, kStart);
    wait(1);
    EXPECT_EQ(starts_, round + 1);
    EXPECT_TRUE(job_ == expected) << to_text(job_) << "\n" << to_text(expected);
    for (const std::int64_t offset : kArguments) {  // writable and readable while it runs, without effect on the job
      write(offset, 5);
      EXPECT_EQ(read(offset), 5u);
    }
    finish_job();
    EXPECT_EQ(read(RegControl), kIdle | kDone | kReady);
  }
}

class AxiLiteRegsField : public AxiLiteRegs {
 protected:
  bool illegal(std::int64_t offset, std::uint32_t value) {
    for (const std::int64_t other : kArguments) write(other, 0);
    if (offset == RegHits + 4) write(RegOptions, 1u << OptionHits);
    if (offset == RegRays + 4 || offset == RegRayCount) write(RegOptions, 1u << OptionList);
    write(offset, value);
    const job_t expected = model_job();
    write(RegControl, kStart);
    wait(1);
    EXPECT_TRUE(job_ == expected);
    finish_job();
    wait(2);
    return job_.illegal;
  }
};

TEST_F(AxiLiteRegsField, BitsOutsideAFieldAreIllegal) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    for (const std::int64_t offset : {RegFrameSize, RegWindowMin, RegWindowMax})
      EXPECT_EQ(illegal(offset, 1u << bit), bit % 16 >= 13) << offset << " bit " << bit;
    for (const std::int64_t offset : {RegImage + 4, RegFrame + 4, RegHits + 4, RegRays + 4})
      EXPECT_EQ(illegal(offset, 1u << bit), bit >= 8) << offset << " bit " << bit;
    EXPECT_EQ(illegal(RegOptions, 1u << bit), bit >= NumOptions || bit == OptionWork) << bit;
    EXPECT_EQ(illegal(RegSteps, 1u << bit), bit >= steps_t_bits) << bit;
    EXPECT_EQ(illegal(RegRayCount, 1u << bit), bit >= ray_count_t_bits) << bit;
  }
}

TEST_F(AxiLiteRegsField, WorkIsToldInHitRecordsOnly) {
  for (const std::int64_t other : {OptionHits, OptionList})
    EXPECT_FALSE(illegal(RegOptions, 1u << OptionWork | 1u << other)) << "option " << other;
}

TEST_F(AxiLiteRegsField, TheHitPointerIsNotLookedAtWithoutHits) {
  write(RegHits + 4, 0xffffffff);
  write(RegControl, kStart);
  wait(1);
  EXPECT_FALSE(job_.illegal);
}

// Of a list nothing of a frame, of a frame nothing of a list; a list's hits are wanted.
TEST_F(AxiLiteRegs, EachKindOfJobLooksAtItsOwnRegisters) {
  for (const bool list : {false, true}) {
    for (const std::int64_t offset : kArguments) write(offset, 0);
    for (const std::int64_t offset : {RegFrame + 4, RegFrameSize, RegWindowMin, RegWindowMax}) write(offset, list ? 0xffffffff : 0);
    for (const std::int64_t offset : {RegRays + 4, RegRayCount}) write(offset, list ? 0 : 0xffffffff);
    write(RegOptions, list ? 1u << OptionList : 0);
    write(RegControl, kStart);
    wait(1);
    EXPECT_FALSE(job_.illegal) << list;
    EXPECT_EQ(job_.is_list, list);
    EXPECT_EQ(job_.want_hits, list);
    finish_job();
    wait(2);
  }
}

TEST_F(AxiLiteRegsField, TheHitPointerOfAListIsLookedAt) {
  write(RegHits + 4, 1u << 8);
  write(RegOptions, 1u << OptionList);
  write(RegControl, kStart);
  wait(1);
  EXPECT_TRUE(job_.illegal);
}

TEST_F(AxiLiteRegs, AnEmptyWindowMaxMeansTheFrame) {
  write(RegFrameSize, 320 | 240 << 16);
  write(RegWindowMin, 7 | 9 << 16);
  write(RegControl, kStart);
  wait(1);
  EXPECT_EQ(job_.x0, 7u);
  EXPECT_EQ(job_.y0, 9u);
  EXPECT_EQ(job_.x1, 320u);
  EXPECT_EQ(job_.y1, 240u);
}

TEST_F(AxiLiteRegs, AResetInAnAccessLeavesThemUsable) {
  for (int cut = 0; cut < 4; ++cut) {
    dut_->s_axi_awvalid_i = dut_->s_axi_arvalid_i = 1;
    dut_->s_axi_wvalid_i = cut & 1;
    dut_->s_axi_awaddr_i = RegControl;
    dut_->s_axi_wdata_i = kStart | kRestart;
    dut_->s_axi_wstrb_i = 15;
    wait(cut);
    bus_.idle();
    dut_.reset(1);
    starts_ = 0;
    write(RegHits, 1234);
    EXPECT_EQ(read(RegHits), 1234u);
    wait(5);
    EXPECT_EQ(starts_, 0);
    EXPECT_EQ(read(RegControl), kIdle);
  }
}

}  // namespace castray::tb
