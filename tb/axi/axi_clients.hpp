// SPDX-License-Identifier: Apache-2.0
// Clients of a reader or writer: each offers its requests in order, with gaps, and notes when they are taken.
#pragma once
#include "axi_sub.hpp"

namespace castray::tb {

constexpr unsigned kClients = 3, kMaxBursts = 8;

// V: the unit; Req: what a client asks; Sub: the memory behind the unit.
template <class V, class Req, class Sub> class AxiClients : public testing::TestWithParam<Stalls> {
 protected:
  // One cycle of clients, unit and memory.
  virtual void cycle() = 0;
  // All that was wanted has been done.
  virtual bool finished() = 0;

  void make(SubConfig config, double gap = 0, int burst = 1) {
    config.max_outstanding = kMaxBursts;
    sub_ = std::make_unique<Sub>(config, 5);
    gates_.clear();
    for (unsigned i = 0; i < kClients; ++i) gates_.emplace_back(gap, burst, 100 + i);
    dut_->block_i = 0;
    dut_->req_valid_i = 0;
  }
  void make_stalled(const Stalls& stalls) {
    SubConfig config;
    config.stall = stalls.sink;
    config.burst = stalls.burst;
    config.latency_max = 30;
    make(config, stalls.source, stalls.burst);
  }
  // An error to the beats at 0x2010 and 0x2020.
  void make_failing(unsigned resp) {
    SubConfig config;
    config.resp = resp;
    config.error_from = 0x2010;
    config.error_to = 0x2030;
    make(config);
    errors_ = 0;
  }

  // The requests of this cycle; junk() is what stands where nobody asks.
  template <class Junk> void offer(Junk&& junk) {
    for (unsigned i = 0; i < kClients; ++i) {
      if (!offering_[i] && !wanted_[i].empty()) offering_[i] = gates_[i].open();
      dut_->req_valid_i = (dut_->req_valid_i & ~(1u << i)) | (unsigned{offering_[i]} << i);
      set_port(dut_->req_i[i], offering_[i] ? wanted_[i].front() : junk());
    }
  }
  // accepted(client, request) is told of those that are taken in this cycle.
  template <class Accepted> void take(Accepted&& accepted) {
    for (unsigned i = 0; i < kClients; ++i) {
      if (!offering_[i] || (dut_->req_ready_o >> i & 1) == 0) continue;
      EXPECT_FALSE(dut_->block_i);
      accepted(i, wanted_[i].front());
      taken_.push_back(i);
      wanted_[i].pop_front();
      offering_[i] = false;
    }
  }

  bool nothing_wanted() const {
    return std::all_of(std::begin(wanted_), std::end(wanted_), [](const auto& queue) { return queue.empty(); });
  }
  // Clients that are reset forget what they wanted.
  void forget_wanted() {
    for (auto& queue : wanted_) queue.clear();
    for (bool& offering : offering_) offering = false;
  }
  void until_taken(std::size_t count) {
    for (int i = 0; i < 5000 && taken_.size() < count; ++i) cycle();
    ASSERT_EQ(taken_.size(), count);
  }
  void run(long limit) {
    for (long i = 0; i < limit && !finished(); ++i) cycle();
    EXPECT_TRUE(finished()) << "something is missing";
    for (int i = 0; i < 4; ++i) cycle();
    EXPECT_TRUE(dut_->idle_o);
  }
  // How many cycles all that is wanted takes.
  long cycles_to_finish(long limit) {
    long cycles = 0;
    for (; !finished() && cycles < limit; ++cycles) cycle();
    return cycles;
  }
  // Unit, memory and clients, in the midst of whatever they do.
  void reset() {
    dut_->req_valid_i = 0;
    dut_.reset(1);
    sub_->reset();
    forget_wanted();
    EXPECT_TRUE(dut_->idle_o);
  }

  Dut<V> dut_;
  std::unique_ptr<Sub> sub_;
  std::mt19937 rng_{11};
  std::vector<Gate> gates_;
  std::deque<Req> wanted_[kClients];
  bool offering_[kClients] = {};
  std::vector<unsigned> taken_;
  long errors_ = 0, beats_ = 0;
};

}  // namespace castray::tb
