// SPDX-License-Identifier: Apache-2.0
// The reader: every client gets exactly the beats it asked for, in order, whatever the memory does.
// Verilator: -GClients=3 -GMaxReads=8
#include "Vaxi_reader.h"
#include "axi_clients.hpp"

namespace castray::tb {

class AxiReader : public AxiClients<Vaxi_reader, read_req_t, ReadSub> {
 protected:
  struct Expected {
    std::uint64_t addr;
    bool last;
  };

  // Requests from the queues, beats against what is expected.
  void cycle() override {
    offer([&] {
      read_req_t junk;
      junk.addr = rng_() & 0xfff0;
      junk.beats = rng_() % 32;
      return junk;
    });
    sub_->drive(dut_);
    // No path from a ready input to a valid output.
    dut_.settle();
    const bool valid = dut_->m_axi_arvalid_o;
    dut_->m_axi_arready_i = !dut_->m_axi_arready_i;
    dut_.settle();
    EXPECT_EQ(dut_->m_axi_arvalid_o, valid);
    dut_->m_axi_arready_i = !dut_->m_axi_arready_i;
    dut_.settle();

    sub_->observe(dut_);
    errors_ += dut_->error_o;
    beats_ += dut_->beat_o;
    if (__builtin_popcount(dut_->rsp_valid_o) > 1) ADD_FAILURE() << "a beat for two clients";
    for (unsigned i = 0; i < kClients; ++i)
      if (dut_->rsp_valid_o >> i & 1) expect_beat(i);
    take([&](unsigned i, const read_req_t& req) {
      for (unsigned b = 0; b < req.beats; ++b) expected_[i].push_back({req.addr + 16 * b, b + 1 == req.beats});
    });
    EXPECT_TRUE(!dut_->idle_o || sub_->outstanding == 0);
    dut_.tick();
  }
  void expect_beat(unsigned client) {
    const read_rsp_t rsp = get_port<read_rsp_t>(dut_->rsp_o);
    if (expected_[client].empty()) {
      ADD_FAILURE() << "client " << client << " did not ask for this beat";
      return;
    }
    EXPECT_EQ(rsp.data, initial_beat(expected_[client].front().addr)) << "client " << client;
    EXPECT_EQ(rsp.last, expected_[client].front().last) << "client " << client;
    expected_[client].pop_front();
  }

  void want(unsigned client, std::uint64_t addr, unsigned beats) {
    read_req_t req;
    req.addr = addr;
    req.beats = beats;
    wanted_[client].push_back(req);
  }
  void want_random(unsigned client) {
    const unsigned beats = 1 + rng_() % 16;
    const std::uint64_t page = std::uint64_t{rng_()} % (1u << 28) << 12;
    want(client, page + 16 * (rng_() % (257 - beats)), beats);
  }
  bool nothing_expected() const {
    return std::all_of(std::begin(expected_), std::end(expected_), [](const auto& queue) { return queue.empty(); });
  }
  bool finished() override { return nothing_wanted() && nothing_expected(); }

  std::deque<Expected> expected_[kClients];
};

TEST_P(AxiReader, GivesEachClientItsBeats) {
  make_stalled(GetParam());
  for (int i = 0; i < 900; ++i) want_random(i % kClients);
  long beats = 0;
  for (const auto& queue : wanted_)
    for (const auto& req : queue) beats += static_cast<long>(req.beats);
  run(200000);
  EXPECT_EQ(beats_, beats);
  EXPECT_EQ(errors_, 0);
}
INSTANTIATE_TEST_SUITE_P(Stalls, AxiReader, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return info.param.name; });

TEST_F(AxiReader, TakesEveryLengthUpToTheEndOfAPage) {
  make({});
  for (unsigned beats = 1; beats <= 16; ++beats) want(1, 0xab'cdef'f000 + 4096 - 16 * beats, beats);
  std::vector<unsigned> lengths;
  sub_->on_burst = [&](unsigned id, std::uint64_t addr, unsigned beats) {
    EXPECT_EQ(id, 1u);
    EXPECT_EQ(addr, 0xab'cdef'f000 + 4096 - 16 * beats);
    lengths.push_back(beats);
  };
  run(2000);
  ASSERT_EQ(lengths.size(), 16u);
  for (unsigned i = 0; i < 16; ++i) EXPECT_EQ(lengths[i], i + 1);
}

TEST_F(AxiReader, SendsABurstEachCycle) {
  make({});
  for (int i = 0; i < 300; ++i) want(i % kClients, 0x1000 + 16 * i, 1);
  EXPECT_LE(cycles_to_finish(2000), 300 + 6);
}

TEST_F(AxiReader, TakesABeatEachCycle) {
  make({});
  for (int i = 0; i < 60; ++i) want(i % kClients, 0x1000 + 256 * i, 16);
  EXPECT_LE(cycles_to_finish(5000), 60 * 16 + 6);
}

TEST_F(AxiReader, HasAtMostMaxReadsOutstanding) {
  make({});
  sub_->config().latency_min = sub_->config().latency_max = 100000;
  for (int i = 0; i < 60; ++i) want(i % kClients, 0x1000 + 256 * i, 4);
  for (int i = 0; i < 200; ++i) cycle();
  EXPECT_EQ(taken_.size(), kMaxBursts);
  EXPECT_EQ(sub_->outstanding, kMaxBursts);
  EXPECT_FALSE(dut_->idle_o);
}

TEST_F(AxiReader, CountsRequestsThatTheAddressChannelHolds) {
  make({});
  sub_->stall_ar = true;
  for (int i = 0; i < 9; ++i) want(0, 0x1000 + 256 * i, 4);
  for (int i = 0; i < 50; ++i) cycle();
  EXPECT_EQ(taken_.size(), 2u) << "the address register has two places";
  EXPECT_FALSE(dut_->idle_o);
  sub_->stall_ar = false;
  run(1000);
}

TEST_F(AxiReader, ServesClientsInTurn) {
  make({});
  for (int i = 0; i < 300; ++i) want(i % kClients, 0x1000 + 256 * i, 1 + i % 7);
  run(20000);
  for (std::size_t i = 0; i + 1 < taken_.size(); ++i) EXPECT_EQ(taken_[i + 1], (taken_[i] + 1) % kClients);
}

TEST_F(AxiReader, KeepsABusyClientFromStarvingARareOne) {
  make({});
  for (int i = 0; i < 400; ++i) want(2, 0x1000 + 256 * i, 16);
  for (int i = 0; i < 500; ++i) cycle();
  const std::size_t before = taken_.size();
  want(0, 0x80000, 1);
  until_taken(before + 3);
  EXPECT_TRUE(taken_[before] == 0 || taken_[before + 1] == 0);
}

TEST_F(AxiReader, ReportsAnErrorOnceForEachBeat) {
  for (const unsigned resp : {2u, 3u}) {
    make_failing(resp);
    want(1, 0x2000, 8);
    want(2, 0x3000, 8);
    run(1000);
    EXPECT_EQ(errors_, 2) << "response " << resp;
  }
}

TEST_F(AxiReader, TakesExclusiveOkayForNoError) {
  SubConfig config;
  config.resp = 1;
  config.error_to = ~0ull;
  make(config);
  want(0, 0x2000, 4);
  run(1000);
  EXPECT_EQ(errors_, 0);
}

// While blocked nothing new is taken, what was taken is answered, and idle says when; a client may
// be reset meanwhile and come back with another request.
TEST_F(AxiReader, ForgetsWaitingClientsWhileBlocked) {
  make({});
  sub_->config().latency_min = sub_->config().latency_max = 20;
  for (unsigned client = 0; client < kClients; ++client) {
    for (int i = 0; i < 20; ++i) want(client, 0x1000 + 256 * i, 4);
    const std::size_t before = taken_.size();
    until_taken(before + 5 + client);  // MaxReads not yet reached: one waits in turn
    dut_->block_i = 1;
    for (int i = 0; i < 3; ++i) cycle();
    const std::size_t at_block = taken_.size();
    forget_wanted();
    for (int i = 0; i < 200; ++i) cycle();
    EXPECT_EQ(taken_.size(), at_block);
    EXPECT_TRUE(nothing_expected());
    EXPECT_TRUE(dut_->idle_o);
    dut_->block_i = 0;
    const unsigned other = (client + 1) % kClients;
    want(other, 0x70000, 3);
    run(200);
    EXPECT_EQ(taken_.back(), other);
  }
}

TEST_F(AxiReader, IsUsableAfterAResetInMidBurst) {
  SubConfig config;
  config.stall = 0.3;
  config.latency_max = 12;
  make(config);
  for (int cut = 1; cut < 80; ++cut) {
    for (int i = 0; i < 12; ++i) want_random(i % kClients);
    for (int i = 0; i < cut; ++i) cycle();
    dut_->m_axi_rvalid_i = 0;
    reset();
    for (auto& queue : expected_) queue.clear();
    for (int i = 0; i < 6; ++i) want_random(i % kClients);
    run(2000);
  }
}

}  // namespace castray::tb
