// SPDX-License-Identifier: Apache-2.0
// The writer: every burst arrives whole, once, with its strobes, whatever the memory does.
// Verilator: -GClients=3 -GMaxWrites=8
#include "Vaxi_writer.h"
#include "axi_clients.hpp"

namespace castray::tb {

class AxiWriter : public AxiClients<Vaxi_writer, write_req_t, WriteSub> {
 protected:
  void make(SubConfig config) {
    AxiClients::make(config);
    follow();
  }
  // Each burst that arrives is the next one that its client sent.
  void follow() {
    sub_->on_burst = [this](unsigned id, std::uint64_t addr, unsigned beats) {
      ASSERT_FALSE(sent_[id].empty());
      EXPECT_EQ(addr, sent_[id].front().addr);
      EXPECT_EQ(beats, sent_[id].front().beats);
      sent_[id].pop_front();
    };
  }

  void cycle() override {
    offer([&] { return make_item(0, 2); });
    sub_->drive(dut_);
    // No path from a ready input to a valid output.
    dut_.settle();
    const bool aw = dut_->m_axi_awvalid_o, w = dut_->m_axi_wvalid_o;
    dut_->m_axi_awready_i = !dut_->m_axi_awready_i;
    dut_->m_axi_wready_i = !dut_->m_axi_wready_i;
    dut_.settle();
    EXPECT_EQ(dut_->m_axi_awvalid_o, aw);
    EXPECT_EQ(dut_->m_axi_wvalid_o, w);
    dut_->m_axi_awready_i = !dut_->m_axi_awready_i;
    dut_->m_axi_wready_i = !dut_->m_axi_wready_i;
    dut_.settle();

    sub_->observe(dut_);
    errors_ += dut_->error_o;
    beats_ += dut_->beat_o;
    take([&](unsigned i, const write_req_t& req) { sent_[i].push_back(req); });
    EXPECT_TRUE(!dut_->idle_o || sub_->outstanding == 0);
    dut_.tick();
  }

  write_req_t make_item(std::uint64_t addr, unsigned beats) {
    write_req_t item;
    item.addr = addr;
    item.beats = beats;
    item.strb = rng_() | std::uint64_t{rng_()} << 32;
    for (auto& word : item.data) word = static_cast<std::uint32_t>(rng_());
    return item;
  }
  // Each client writes an area of its own, so the order between clients does not matter.
  void want(unsigned client, std::uint64_t addr, unsigned beats) {
    const write_req_t item = make_item(addr, beats);
    wanted_[client].push_back(item);
    for (unsigned b = 0; b < beats; ++b) {
      Beat data;
      std::copy_n(item.data.begin() + 4 * b, 4, data.begin());
      result_->store(addr + 16 * b, data, item.strb >> (16 * b) & 0xffff);
    }
  }
  void want_random(unsigned client) {
    const unsigned beats = 1u << (rng_() % 3);
    want(client, (std::uint64_t{client} << 36) + 16 * beats * (rng_() % 512), beats);
  }
  bool finished() override { return nothing_wanted() && dut_->idle_o; }
  void run(long limit) {
    AxiClients::run(limit);
    for (const auto& queue : sent_) EXPECT_TRUE(queue.empty()) << "taken, but not sent";
  }

  std::unique_ptr<WriteSub> result_ = std::make_unique<WriteSub>(SubConfig{}, 1);  // what memory should hold
  std::deque<write_req_t> sent_[kClients];
};

TEST_P(AxiWriter, WritesEveryBurstWhole) {
  make_stalled(GetParam());
  follow();
  for (int i = 0; i < 1500; ++i) want_random(i % kClients);
  run(200000);
  EXPECT_TRUE(sub_->memory() == result_->memory());
  EXPECT_EQ(beats_, sub_->beats);
  EXPECT_EQ(errors_, 0);
}
INSTANTIATE_TEST_SUITE_P(Stalls, AxiWriter, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return info.param.name; });

TEST_F(AxiWriter, SendsABeatEachCycle) {
  for (const unsigned beats : {1u, 2u, 4u}) {
    make({});
    for (int i = 0; i < 300; ++i) want(i % kClients, 0x1000 + 64 * i, beats);
    EXPECT_LE(cycles_to_finish(5000), 300 * beats + 6) << beats << " beats a burst";
  }
  EXPECT_TRUE(sub_->outstanding == 0);
}

TEST_F(AxiWriter, GoesUpToTheEndOfAPage) {
  make({});
  for (const unsigned beats : {1u, 2u, 4u}) want(2, 0xff'ffff'f000 + 4096 - 16 * beats, beats);
  run(200);
  EXPECT_TRUE(sub_->memory() == result_->memory());
}

TEST_F(AxiWriter, HasAtMostMaxWritesOutstanding) {
  make({});
  sub_->config().latency_min = sub_->config().latency_max = 100000;
  for (int i = 0; i < 60; ++i) want(i % kClients, 0x1000 + 64 * i, 2);
  for (int i = 0; i < 200; ++i) cycle();
  EXPECT_EQ(taken_.size(), kMaxBursts);
  EXPECT_EQ(sub_->outstanding, kMaxBursts);
  EXPECT_FALSE(dut_->idle_o);
}

TEST_F(AxiWriter, LetsDataGoAheadOfAddresses) {
  make({});
  sub_->stall_aw = true;
  for (int i = 0; i < 9; ++i) want(0, 0x1000 + 64 * i, 4);
  for (int i = 0; i < 60; ++i) cycle();
  EXPECT_EQ(taken_.size(), 2u) << "the address register has two places";
  EXPECT_EQ(sub_->beats, 8);
  sub_->stall_aw = false;
  run(500);
  EXPECT_TRUE(sub_->memory() == result_->memory());
}

TEST_F(AxiWriter, LetsAnAddressGoAheadOfItsData) {
  make({});
  sub_->stall_w = true;
  for (int i = 0; i < 9; ++i) want(0, 0x1000 + 64 * i, 4);
  for (int i = 0; i < 60; ++i) cycle();
  EXPECT_EQ(taken_.size(), 1u) << "one burst is in the register";
  EXPECT_EQ(sub_->bursts, 1);
  sub_->stall_w = false;
  run(500);
  EXPECT_TRUE(sub_->memory() == result_->memory());
}

TEST_F(AxiWriter, ServesClientsInTurn) {
  make({});
  for (int i = 0; i < 300; ++i) want(i % kClients, 0x1000 + 64 * i, 1u << i % 3);
  run(20000);
  for (std::size_t i = 0; i + 1 < taken_.size(); ++i) EXPECT_EQ(taken_[i + 1], (taken_[i] + 1) % kClients);
}

TEST_F(AxiWriter, ReportsAnErrorOnceForEachBurst) {
  for (const unsigned resp : {2u, 3u}) {
    make_failing(resp);
    follow();
    want(1, 0x2000, 4);
    want(2, 0x3000, 4);
    run(200);
    EXPECT_EQ(errors_, 1) << "response " << resp;
  }
}

// The error of the very last response is seen no later than idle.
TEST_F(AxiWriter, ReportsAnErrorNotAfterIdle) {
  SubConfig config;
  config.error_to = ~0ull;
  make(config);
  want(0, 0x2000, 1);
  for (int i = 0; i < 100 && !finished(); ++i) cycle();
  EXPECT_EQ(errors_ + dut_->error_o, 1);
}

TEST_F(AxiWriter, TakesExclusiveOkayForNoError) {
  SubConfig config;
  config.resp = 1;
  config.error_to = ~0ull;
  make(config);
  want(0, 0x2000, 1);
  run(200);
  EXPECT_EQ(errors_, 0);
}

// What was taken is sent whole though blocked; a client may be reset meanwhile.
TEST_F(AxiWriter, SendsWhatItTookWhileBlocked) {
  SubConfig config;
  config.stall = 0.5;
  make(config);
  for (int round = 0; round < 30; ++round) {
    for (int i = 0; i < 30; ++i) want_random(i % kClients);
    const std::size_t before = taken_.size();
    until_taken(before + 1 + rng_() % 20);
    dut_->block_i = 1;
    forget_wanted();
    run(500);
    dut_->block_i = 0;
    const unsigned other = rng_() % kClients;
    want(other, 0x70000, 4);
    run(200);
    EXPECT_EQ(taken_.back(), other);
  }
}

TEST_F(AxiWriter, IsUsableAfterAResetInMidBurst) {
  SubConfig config;
  config.stall = 0.3;
  config.latency_max = 12;
  make(config);
  for (int cut = 1; cut < 80; ++cut) {
    for (int i = 0; i < 12; ++i) want_random(i % kClients);
    for (int i = 0; i < cut; ++i) cycle();
    dut_->m_axi_bvalid_i = 0;
    reset();
    for (auto& queue : sent_) queue.clear();
    for (int i = 0; i < 6; ++i) want_random(i % kClients);
    run(2000);
  }
}

}  // namespace castray::tb
