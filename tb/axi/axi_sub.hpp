// SPDX-License-Identifier: Apache-2.0
// A small AXI4 subordinate for unit tests, in two halves: seeded stalls and latencies, answers of
// different IDs out of order and interleaved, error responses by address, and checks of what a
// master must keep. drive() sets the inputs of a cycle, observe() looks at the settled outputs.
#pragma once
#include <array>
#include <map>
#include <set>

#include "dut.hpp"

namespace castray::tb {

using Beat = std::array<std::uint32_t, 4>;

// What memory holds before anything is written: each beat differs from every other.
inline Beat initial_beat(std::uint64_t addr) {
  Beat beat;
  for (unsigned i = 0; i < 4; ++i) beat[i] = static_cast<std::uint32_t>((addr / 16 * 4 + i) * 2654435761u + 12345);
  return beat;
}

struct SubConfig {
  double stall = 0;         // chance that a channel stands still in a cycle
  int burst = 1;            // mean length of a run of equal decisions
  int latency_min = 1;      // cycles from a request to its answer
  int latency_max = 1;
  std::uint64_t error_from = 0, error_to = 0;  // requests in [from, to) are answered with errors
  unsigned resp = 2;        // the error: SLVERR 2 or DECERR 3
  unsigned max_outstanding = 16;
};

// Checks that a channel's payload is kept until it is taken.
class Held {
 public:
  void cycle(const char* name, bool valid, bool ready, std::uint64_t payload) {
    if (waiting_) {
      EXPECT_TRUE(valid) << name << " was withdrawn";
      if (valid) EXPECT_EQ(payload, payload_) << name << " changed while it waited";
    }
    waiting_ = valid && !ready;
    payload_ = payload;
  }
  void forget() { waiting_ = false; }

 private:
  bool waiting_ = false;
  std::uint64_t payload_ = 0;
};

// What AXI and this core's own rules ask of an address.
inline void check_address(std::uint64_t addr, unsigned len, unsigned size, unsigned burst, unsigned cache, unsigned prot,
                          unsigned max_len) {
  EXPECT_LE(len, max_len);
  EXPECT_EQ(size, 4u);
  EXPECT_EQ(burst, 1u);
  EXPECT_EQ(cache, 3u);
  EXPECT_EQ(prot, 0u);
  EXPECT_EQ(addr % 16, 0u);
  EXPECT_EQ(addr / 4096, (addr + 16 * len + 15) / 4096) << "a burst crosses 4 KiB";
}

class ReadSub {
 public:
  using Fetch = std::function<Beat(std::uint64_t addr)>;
  ReadSub(SubConfig config, unsigned seed, Fetch fetch = initial_beat)
      : config_(config), fetch_(std::move(fetch)), rng_(seed), ar_(config.stall, config.burst, seed + 1),
        r_(config.stall, config.burst, seed + 2) {}

  template <class D> void drive(D& dut) {
    dut->m_axi_arready_i = !silent && !(stall_ar || !ar_.open());
    sending_ = -1;
    std::vector<int> able;
    for (auto& [id, queue] : queues_)
      if (!queue.empty() && queue.front().due <= now_) able.push_back(id);
    if (!able.empty() && !silent && r_.open()) sending_ = able[rng_() % able.size()];
    dut->m_axi_rvalid_i = sending_ >= 0;
    // Meaningless where nothing is valid.
    dut->m_axi_rid_i = sending_ >= 0 ? static_cast<unsigned>(sending_) : rng_() & 15;
    dut->m_axi_rlast_i = rng_() & 1;
    dut->m_axi_rresp_i = rng_() & 3;
    for (int i = 0; i < 4; ++i) dut->m_axi_rdata_i[i] = static_cast<std::uint32_t>(rng_());
    if (sending_ >= 0) {
      const Burst& burst = queues_[sending_].front();
      const std::uint64_t addr = burst.addr + 16 * burst.sent;
      const Beat beat = fetch_(addr);
      for (int i = 0; i < 4; ++i) dut->m_axi_rdata_i[i] = beat[i];
      dut->m_axi_rlast_i = burst.sent == burst.len;
      dut->m_axi_rresp_i = addr >= config_.error_from && addr < config_.error_to ? config_.resp : 0;
    }
  }

  template <class D> void observe(D& dut) {
    EXPECT_EQ(dut->m_axi_rready_o, 1) << "the clients have reserved room";
    const bool valid = dut->m_axi_arvalid_o, ready = dut->m_axi_arready_i;
    held_.cycle("AR", valid, ready, dut->m_axi_araddr_o ^ std::uint64_t{dut->m_axi_arlen_o} << 44 ^ std::uint64_t{dut->m_axi_arid_o} << 56);
    if (valid)
      check_address(dut->m_axi_araddr_o, dut->m_axi_arlen_o, dut->m_axi_arsize_o, dut->m_axi_arburst_o,
                    dut->m_axi_arcache_o, dut->m_axi_arprot_o, 15);
    if (sending_ >= 0) {
      auto& queue = queues_[sending_];
      if (queue.front().sent++ == queue.front().len) {
        queue.pop_front();
        --outstanding;
      }
    }
    if (valid && ready) {
      const int span = config_.latency_max - config_.latency_min + 1;
      queues_[dut->m_axi_arid_o].push_back({dut->m_axi_araddr_o, dut->m_axi_arlen_o, 0u,
                                            now_ + config_.latency_min + static_cast<long>(rng_() % span)});
      EXPECT_LE(++outstanding, config_.max_outstanding);
      ++bursts;
      if (on_burst) on_burst(dut->m_axi_arid_o, dut->m_axi_araddr_o, dut->m_axi_arlen_o + 1u);
    }
    ++now_;
  }

  // The memory is reset together with the core.
  void reset() {
    queues_.clear();
    outstanding = 0;
    held_.forget();
    sending_ = -1;
  }

  SubConfig& config() { return config_; }
  bool stall_ar = false;  // AR is never taken
  bool silent = false;    // nothing is taken or answered
  unsigned outstanding = 0;
  long bursts = 0;
  std::function<void(unsigned id, std::uint64_t addr, unsigned beats)> on_burst;

 private:
  struct Burst {
    std::uint64_t addr;
    unsigned len, sent;
    long due;
  };
  SubConfig config_;
  Fetch fetch_;
  std::mt19937 rng_;
  Gate ar_, r_;
  Held held_;
  std::map<int, std::deque<Burst>> queues_;
  int sending_ = -1;
  long now_ = 0;
};

class WriteSub {
 public:
  WriteSub(SubConfig config, unsigned seed)
      : config_(config), rng_(seed), aw_(config.stall, config.burst, seed + 1), w_(config.stall, config.burst, seed + 2),
        b_(config.stall, config.burst, seed + 3) {}

  template <class D> void drive(D& dut) {
    dut->m_axi_awready_i = !silent && !stall_aw && aw_.open();
    dut->m_axi_wready_i = !silent && !stall_w && w_.open();
    std::vector<std::size_t> able;  // the oldest response of each ID that is due
    std::set<unsigned> seen;
    for (std::size_t i = 0; i < responses_.size(); ++i)
      if (seen.insert(responses_[i].id).second && responses_[i].due <= now_) able.push_back(i);
    dut->m_axi_bvalid_i = !silent && !able.empty() && b_.open();
    dut->m_axi_bid_i = rng_() & 15;
    dut->m_axi_bresp_i = rng_() & 3;
    if (dut->m_axi_bvalid_i) {
      sending_ = able[rng_() % able.size()];
      dut->m_axi_bid_i = responses_[sending_].id;
      dut->m_axi_bresp_i = responses_[sending_].resp;
    }
  }

  template <class D> void observe(D& dut) {
    EXPECT_EQ(dut->m_axi_bready_o, 1);
    const bool aw = dut->m_axi_awvalid_o && dut->m_axi_awready_i, w = dut->m_axi_wvalid_o && dut->m_axi_wready_i;
    held_aw_.cycle("AW", dut->m_axi_awvalid_o, dut->m_axi_awready_i,
                   dut->m_axi_awaddr_o ^ std::uint64_t{dut->m_axi_awlen_o} << 44 ^ std::uint64_t{dut->m_axi_awid_o} << 56);
    Beat data;
    std::uint64_t sum = dut->m_axi_wstrb_o ^ std::uint64_t{dut->m_axi_wlast_o} << 63;
    for (int i = 0; i < 4; ++i) {
      data[i] = dut->m_axi_wdata_o[i];
      sum = sum * 1000003 + data[i];
    }
    held_w_.cycle("W", dut->m_axi_wvalid_o, dut->m_axi_wready_i, sum);
    if (dut->m_axi_awvalid_o)
      check_address(dut->m_axi_awaddr_o, dut->m_axi_awlen_o, dut->m_axi_awsize_o, dut->m_axi_awburst_o,
                    dut->m_axi_awcache_o, dut->m_axi_awprot_o, 3);
    if (dut->m_axi_bvalid_i) responses_.erase(responses_.begin() + static_cast<long>(sending_)), --outstanding;
    if (aw) {
      addresses_.push_back({dut->m_axi_awaddr_o, dut->m_axi_awlen_o, dut->m_axi_awid_o});
      EXPECT_LE(++outstanding, config_.max_outstanding);
      ++bursts;
    }
    if (w) data_.push_back({data, dut->m_axi_wstrb_o, static_cast<bool>(dut->m_axi_wlast_o)}), ++beats;
    while (!addresses_.empty() && !data_.empty()) {  // the data comes in the order of the addresses
      const auto [addr, len, id] = addresses_.front();
      const std::uint64_t at = addr + 16 * beat_;
      const bool bad = at >= config_.error_from && at < config_.error_to;
      failed_ |= bad;
      if (!bad) store(at, data_.front().data, data_.front().strb);
      EXPECT_EQ(data_.front().last, beat_ == len) << "WLAST";
      data_.pop_front();
      if (beat_++ == len) {
        const int span = config_.latency_max - config_.latency_min + 1;
        responses_.push_back({id, failed_ ? config_.resp : 0, now_ + config_.latency_min + static_cast<long>(rng_() % span)});
        if (on_burst) on_burst(id, addr, len + 1);
        addresses_.pop_front();
        beat_ = 0;
        failed_ = false;
      }
    }
    ++now_;
  }

  Beat load(std::uint64_t addr) const {
    const auto it = memory_.find(addr);
    return it == memory_.end() ? initial_beat(addr) : it->second;
  }
  void store(std::uint64_t addr, const Beat& data, unsigned strb) {
    Beat beat = load(addr);
    for (unsigned i = 0; i < 16; ++i) {
      if ((strb >> i & 1) == 0) continue;
      const std::uint32_t mask = 0xffu << (8 * (i % 4));
      beat[i / 4] = (beat[i / 4] & ~mask) | (data[i / 4] & mask);
    }
    memory_[addr] = beat;
  }

  void reset() {
    addresses_.clear();
    data_.clear();
    responses_.clear();
    outstanding = 0;
    beat_ = 0;
    failed_ = false;
    held_aw_.forget();
    held_w_.forget();
  }

  SubConfig& config() { return config_; }
  const std::map<std::uint64_t, Beat>& memory() const { return memory_; }
  bool stall_aw = false, stall_w = false, silent = false;
  unsigned outstanding = 0;
  long bursts = 0, beats = 0;
  std::function<void(unsigned id, std::uint64_t addr, unsigned beats)> on_burst;

 private:
  struct Address {
    std::uint64_t addr;
    unsigned len, id;
  };
  struct Data {
    Beat data;
    unsigned strb;
    bool last;
  };
  struct Response {
    unsigned id, resp;
    long due;
  };
  SubConfig config_;
  std::mt19937 rng_;
  Gate aw_, w_, b_;
  Held held_aw_, held_w_;
  std::deque<Address> addresses_;
  std::deque<Data> data_;
  std::deque<Response> responses_;
  std::map<std::uint64_t, Beat> memory_;
  std::size_t sending_ = 0;
  unsigned beat_ = 0;
  bool failed_ = false;
  long now_ = 0;
};

}  // namespace castray::tb
