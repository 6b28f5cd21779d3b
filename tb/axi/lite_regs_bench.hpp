// SPDX-License-Identifier: Apache-2.0
// The register block behind an AXI4-Lite manager, the core around it played by the test.
#pragma once
#include "Vaxi_lite_regs.h"
#include "axi/axi_lite_regs.hpp"
#include "lite_bus.hpp"

namespace castray::tb {

inline constexpr std::uint32_t kStart = 1u << CtrlStart, kDone = 1u << CtrlDone, kIdle = 1u << CtrlIdle, kReady = 1u << CtrlReady,
                        kRestart = 1u << CtrlAutoRestart, kInterrupt = 1u << CtrlInterrupt;

inline constexpr std::int64_t kArguments[] = {RegImage,      RegImage + 4,  RegFrame,     RegFrame + 4, RegHits,      RegHits + 4,  RegImageBytes,
                                              RegFrameBytes, RegHitsBytes,  RegFrameSize, RegOptions,   RegWindowMin, RegWindowMax, RegSteps,
                                              RegRays,       RegRays + 4,   RegRayBytes,  RegRayCount};

class AxiLiteRegs : public testing::Test {
 protected:
  using D = Dut<Vaxi_lite_regs>;
  AxiLiteRegs() {
    dut_->done_i = 0;
    dut_->error_i = 0;
    dut_->number_i = 0, dut_->count_i = 0;
    dut_.reset();
  }
  void tick() {
    dut_->number_i = turn_, dut_->count_i = counts_[turn_];
    turn_ = (turn_ + 1) % Counters;
    dut_.settle();
    starts_ += dut_->start_o;
    if (dut_->start_o) job_ = get_port<job_t>(dut_->job_o);
    EXPECT_TRUE(starts_ == 0 || get_port<job_t>(dut_->job_o) == job_) << "the job changed while it runs";
    dut_.tick();
  }
  void wait(int cycles) {
    for (int i = 0; i < cycles; ++i) tick();
  }
  void finish_job() {
    dut_->done_i = 1;
    tick();
    dut_->done_i = 0;
  }
  // Six cycles, in the second of which the write happens, and in cycle `done_at` the end of the job.
  void write_beside_done(std::int64_t offset, std::uint32_t data, int done_at) {
    dut_->s_axi_awvalid_i = dut_->s_axi_wvalid_i = 1;
    dut_->s_axi_awaddr_i = static_cast<unsigned>(offset);
    dut_->s_axi_wdata_i = data;
    dut_->s_axi_wstrb_i = 15;
    dut_->s_axi_bready_i = 1;
    for (int cycle = 0; cycle < 6; ++cycle) {
      dut_->done_i = cycle == done_at;
      tick();
      dut_->s_axi_awvalid_i = dut_->s_axi_wvalid_i = 0;
    }
    dut_->done_i = 0;
    bus_.idle();
  }
  std::uint32_t read(std::int64_t offset) { return bus_.read(offset); }
  void write(std::int64_t offset, std::uint32_t data, unsigned strb = 15) { bus_.write(offset, data, strb); }
  job_t model_job() {
    return job_of_registers([&](std::int64_t offset) { return read(offset); });
  }

  D dut_;
  int starts_ = 0, turn_ = 0;
  std::array<std::uint64_t, Counters> counts_{};
  job_t job_;
  LiteBus<D> bus_{dut_, [this] { tick(); }};
};

}  // namespace castray::tb
