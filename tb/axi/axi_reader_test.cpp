// SPDX-License-Identifier: Apache-2.0
// The reader: every client gets exactly the beats it asked for, in order, whatever the memory does.
// Verilator: -GClients=3 -GMaxReads=8
#include "Vaxi_reader.h"
#include "axi_sub.hpp"

namespace castray::tb {

constexpr unsigned kClients = 3, kMaxReads = 8;

class AxiReader : public testing::TestWithParam<Stalls> {
 protected:
  struct Expected {
    std::uint64_t addr;
    bool last;
  };

  static SubConfig config_of(const Stalls& stalls) {
    SubConfig config;
    config.stall = stalls.sink;
    config.burst = stalls.burst;
    config.latency_max = 30;
    config.max_outstanding = kMaxReads;
    return config;
  }

  void make(SubConfig config, double gap = 0, int burst = 1) {
    config.max_outstanding = kMaxReads;
    sub_ = std::make_unique<ReadSub>(config, 5);
    gates_.clear();
    for (unsigned i = 0; i < kClients; ++i) gates_.emplace_back(gap, burst, 100 + i);
    dut_->block_i = 0;
  }

  // One cycle: requests from the queues, beats against what is expected.
  void cycle() {
    for (unsigned i = 0; i < kClients; ++i) {
      if (!offering_[i] && !wanted_[i].empty()) offering_[i] = gates_[i].open();
      dut_->req_valid_i = (dut_->req_valid_i & ~(1u << i)) | (unsigned{offering_[i]} << i);
      read_req_t junk;
      junk.addr = rng_() & 0xfff0;
      junk.beats = rng_() % 32;
      set_port(dut_->req_i[i], offering_[i] ? wanted_[i].front() : junk);
    }
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
    for (unsigned i = 0; i < kClients; ++i) {
      if (dut_->rsp_valid_o >> i & 1) {
        const read_rsp_t rsp = get_port<read_rsp_t>(dut_->rsp_o);
        if (expected_[i].empty()) {
          ADD_FAILURE() << "client " << i << " did not ask for this beat";
        } else {
          EXPECT_EQ(rsp.data, initial_beat(expected_[i].front().addr)) << "client " << i;
          EXPECT_EQ(rsp.last, expected_[i].front().last) << "client " << i;
          expected_[i].pop_front();
          --pending_;
        }
      }
      if (offering_[i] && (dut_->req_ready_o >> i & 1)) {
        EXPECT_FALSE(dut_->block_i);
        const read_req_t req = wanted_[i].front();
        for (unsigned b = 0; b < req.beats; ++b) expected_[i].push_back({req.addr + 16 * b, b + 1 == req.beats});
        pending_ += static_cast<long>(req.beats);
        taken_.push_back(i);
        wanted_[i].pop_front();
        offering_[i] = false;
      }
    }
    EXPECT_TRUE(!dut_->idle_o || sub_->outstanding == 0);
    dut_.tick();
  }

  void until_taken(std::size_t count) {
    for (int i = 0; i < 5000 && taken_.size() < count; ++i) cycle();
    ASSERT_EQ(taken_.size(), count);
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
  bool finished() const {
    bool none = pending_ == 0;
    for (unsigned i = 0; i < kClients; ++i) none = none && wanted_[i].empty();
    return none;
  }
  void run(long limit) {
    for (long i = 0; i < limit && !finished(); ++i) cycle();
    EXPECT_TRUE(finished()) << "beats are missing";
    for (int i = 0; i < 4; ++i) cycle();
    EXPECT_TRUE(dut_->idle_o);
  }

  Dut<Vaxi_reader> dut_;
  std::unique_ptr<ReadSub> sub_;
  std::mt19937 rng_{11};
  std::vector<Gate> gates_;
  std::deque<read_req_t> wanted_[kClients];
  std::deque<Expected> expected_[kClients];
  bool offering_[kClients] = {};
  std::vector<unsigned> taken_;
  long pending_ = 0, errors_ = 0, beats_ = 0;
};

TEST_P(AxiReader, GivesEachClientItsBeats) {
  make(config_of(GetParam()), GetParam().source, GetParam().burst);
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
  long cycles = 0;
  for (; !finished() && cycles < 2000; ++cycles) cycle();
  EXPECT_LE(cycles, 300 + 6);
}

TEST_F(AxiReader, TakesABeatEachCycle) {
  make({});
  for (int i = 0; i < 60; ++i) want(i % kClients, 0x1000 + 256 * i, 16);
  long cycles = 0;
  for (; !finished() && cycles < 5000; ++cycles) cycle();
  EXPECT_LE(cycles, 60 * 16 + 6);
}

TEST_F(AxiReader, HasAtMostMaxReadsOutstanding) {
  make({});
  sub_->config().latency_min = sub_->config().latency_max = 100000;
  for (int i = 0; i < 60; ++i) want(i % kClients, 0x1000 + 256 * i, 4);
  for (int i = 0; i < 200; ++i) cycle();
  EXPECT_EQ(taken_.size(), kMaxReads);
  EXPECT_EQ(sub_->outstanding, kMaxReads);
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
    SubConfig config;
    config.resp = resp;
    config.error_from = 0x2010;
    config.error_to = 0x2030;
    make(config);
    errors_ = 0;
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
    for (unsigned i = 0; i < kClients; ++i) {
      wanted_[i].clear();
      offering_[i] = false;
    }
    for (int i = 0; i < 200; ++i) cycle();
    EXPECT_EQ(taken_.size(), at_block);
    EXPECT_EQ(pending_, 0);
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
    dut_->req_valid_i = 0;
    dut_->m_axi_rvalid_i = 0;
    dut_.reset(1);
    sub_->reset();
    for (unsigned i = 0; i < kClients; ++i) {
      wanted_[i].clear();
      expected_[i].clear();
      offering_[i] = false;
    }
    pending_ = 0;
    EXPECT_TRUE(dut_->idle_o);
    for (int i = 0; i < 6; ++i) want_random(i % kClients);
    run(2000);
  }
}

}  // namespace castray::tb
