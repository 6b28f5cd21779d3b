// SPDX-License-Identifier: Apache-2.0
// An AXI4-Lite manager for tests: one access at a time, each channel with a delay of its own.
// Checks that an answer is kept until taken and that it is OKAY.
#pragma once
#include "dut.hpp"

namespace castray::tb {

// Cycles by which a channel is late.
struct LiteDelays {
  int address = 0, data = 0, response = 0;
};

template <class D> class LiteBus {
 public:
  LiteBus(D& dut, std::function<void()> tick) : dut_(dut), tick_(std::move(tick)) { idle(); }

  void idle() {
    dut_->s_axi_awvalid_i = dut_->s_axi_wvalid_i = dut_->s_axi_arvalid_i = 0;
    dut_->s_axi_bready_i = dut_->s_axi_rready_i = 0;
  }

  void write(std::int64_t offset, std::uint32_t data, unsigned strb = 15, LiteDelays delays = {}) {
    bool address_sent = false, data_sent = false;
    int waited = 0;
    bool had_response = false;
    for (int cycle = 0; cycle < 200; ++cycle) {
      dut_->s_axi_awvalid_i = !address_sent && cycle >= delays.address;
      dut_->s_axi_awaddr_i = static_cast<unsigned>(offset);
      dut_->s_axi_wvalid_i = !data_sent && cycle >= delays.data;
      dut_->s_axi_wdata_i = data;
      dut_->s_axi_wstrb_i = strb;
      dut_->s_axi_bready_i = had_response && waited >= delays.response;
      dut_.settle();
      address_sent |= dut_->s_axi_awvalid_i && dut_->s_axi_awready_o;
      data_sent |= dut_->s_axi_wvalid_i && dut_->s_axi_wready_o;
      const bool response = dut_->s_axi_bvalid_o;
      if (response) EXPECT_EQ(dut_->s_axi_bresp_o, 0);
      EXPECT_TRUE(response || !had_response) << "the write's answer was withdrawn";
      const bool done = response && dut_->s_axi_bready_i;
      if (had_response) ++waited;
      had_response = response;
      tick_();
      if (done) {
        EXPECT_TRUE(address_sent && data_sent);
        idle();
        return;
      }
    }
    ADD_FAILURE() << "no answer to the write of " << offset;
    idle();
  }

  std::uint32_t read(std::int64_t offset, LiteDelays delays = {}) {
    bool sent = false, had_response = false;
    int waited = 0;
    std::uint32_t data = 0;
    for (int cycle = 0; cycle < 200; ++cycle) {
      dut_->s_axi_arvalid_i = !sent && cycle >= delays.address;
      dut_->s_axi_araddr_i = static_cast<unsigned>(offset);
      dut_->s_axi_rready_i = had_response && waited >= delays.response;
      dut_.settle();
      sent |= dut_->s_axi_arvalid_i && dut_->s_axi_arready_o;
      const bool response = dut_->s_axi_rvalid_o;
      if (response) {
        EXPECT_EQ(dut_->s_axi_rresp_o, 0);
        if (had_response) EXPECT_EQ(dut_->s_axi_rdata_o, data) << "the answer changed while it waited";
        data = dut_->s_axi_rdata_o;
      }
      EXPECT_TRUE(response || !had_response) << "the read's answer was withdrawn";
      const bool done = response && dut_->s_axi_rready_i;
      if (had_response) ++waited;
      had_response = response;
      tick_();
      if (done) {
        idle();
        return data;
      }
    }
    ADD_FAILURE() << "no answer to the read of " << offset;
    idle();
    return 0;
  }

 private:
  D& dut_;
  std::function<void()> tick_;
};

}  // namespace castray::tb
