// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Caches, the memory behind them and two AXI ports together: right lines, no hang while every
// channel stalls and another client loads the ports, and what a hit and a miss cost.
#include <map>
#include <set>

#include "../axi/axi_sub.hpp"
#include "Vline_system.h"
#include "line_store.hpp"

namespace castray::tb {
namespace {

constexpr unsigned kCaches = 3, kIds = 1 << CtxW;
constexpr std::uint64_t kBase = 0xab'cdef'0100;

// One port of the two, by the names that ReadSub uses.
struct PortPins {
  template <class T> struct Bit {
    T& word;
    unsigned at;
    operator unsigned() const { return word >> at & 1; }
    void operator=(unsigned v) { word = static_cast<T>((word & ~(1u << at)) | (v & 1) << at); }
  };
  PortPins(Vline_system& v, unsigned p)
      : m_axi_arready_i{v.m_axi_arready_i, p}, m_axi_rvalid_i{v.m_axi_rvalid_i, p}, m_axi_rlast_i{v.m_axi_rlast_i, p},
        m_axi_arvalid_o{v.m_axi_arvalid_o, p}, m_axi_rready_o{v.m_axi_rready_o, p}, m_axi_araddr_o(v.m_axi_araddr_o[p]),
        m_axi_arid_o(v.m_axi_arid_o[p]), m_axi_arlen_o(v.m_axi_arlen_o[p]), m_axi_arsize_o(v.m_axi_arsize_o[p]),
        m_axi_arburst_o(v.m_axi_arburst_o[p]), m_axi_arcache_o(v.m_axi_arcache_o[p]), m_axi_arprot_o(v.m_axi_arprot_o[p]),
        m_axi_rid_i(v.m_axi_rid_i[p]), m_axi_rresp_i(v.m_axi_rresp_i[p]), m_axi_rdata_i(v.m_axi_rdata_i[p]) {}
  PortPins* operator->() { return this; }
  Bit<CData> m_axi_arready_i, m_axi_rvalid_i, m_axi_rlast_i, m_axi_arvalid_o, m_axi_rready_o;
  QData& m_axi_araddr_o;
  CData &m_axi_arid_o, &m_axi_arlen_o, &m_axi_arsize_o, &m_axi_arburst_o, &m_axi_arcache_o, &m_axi_arprot_o;
  CData &m_axi_rid_i, &m_axi_rresp_i;
  VlWide<4>& m_axi_rdata_i;
};

Beat fetch(std::uint64_t addr) {
  const line_data_t data = data_of((addr - kBase) / 64);
  Beat beat;
  std::copy_n(data.begin() + static_cast<long>((addr - kBase) % 64 / 4), 4, beat.begin());
  return beat;
}

class LineSystem : public testing::TestWithParam<Stalls> {
 protected:
  LineSystem() { make({}, 60, 60); }

  void make(Stalls stalls, int latency_min, int latency_max) {
    SubConfig config{.stall = stalls.sink, .burst = stalls.burst, .latency_min = latency_min, .latency_max = latency_max};
    config.max_outstanding = 32;
    subs_.clear(), source_.clear(), sink_.clear();
    for (unsigned p = 0; p < 2; ++p) subs_.push_back(std::make_unique<ReadSub>(config, 7 + p, fetch));
    for (unsigned c = 0; c < kCaches; ++c) {
      source_.emplace_back(stalls.source, stalls.burst, 50 + c);
      sink_.emplace_back(stalls.sink, stalls.burst, 60 + c);
      wanted[c].clear(), waiting_[c].clear(), offering_[c] = false;
    }
    dut_->base_i = kBase;
    dut_->in_valid_i = dut_->other_valid_i = 0;
    dut_.reset();
    for (int i = 0; i < 300; ++i) cycle();  // the tags are emptied
  }

  void cycle() {
    std::vector<PortPins> pins{{*dut_.operator->(), 0}, {*dut_.operator->(), 1}};
    dut_->in_valid_i = dut_->out_ready_i = 0;
    for (unsigned c = 0; c < kCaches; ++c) {
      if (!offering_[c] && !wanted[c].empty() && waiting_[c].size() < contexts && source_[c].open()) {
        do id_[c] = rng() % kIds;
        while (waiting_[c].contains(id_[c]));
        offering_[c] = true;
      }
      dut_->in_valid_i |= unsigned{offering_[c]} << c;
      dut_->in_id_i[c] = id_[c];
      dut_->in_line_i[c] = offering_[c] ? wanted[c].front() : 0;
      dut_->out_ready_i |= unsigned{sink_[c].open()} << c;
    }
    dut_->other_valid_i = others ? 3 : 0;
    read_req_t other;
    other.addr = 0x5000, other.beats = 4;
    set_port(dut_->other_i, other);
    for (unsigned p = 0; p < 2; ++p) subs_[p]->drive(pins[p]);
    dut_.settle();
    for (unsigned p = 0; p < 2; ++p) subs_[p]->observe(pins[p]);
    for (unsigned c = 0; c < kCaches; ++c) {
      if (dut_->out_valid_o & dut_->out_ready_i & 1u << c) give(c);
      if (!offering_[c] || !(dut_->in_ready_o >> c & 1)) continue;
      waiting_[c][id_[c]] = {wanted[c].front(), dut_.cycles()};
      wanted[c].pop_front();
      offering_[c] = false;
    }
    l2_hits += __builtin_popcount(dut_->l2_hit_o);
    dut_.tick();
  }

  void give(unsigned c) {
    const auto it = waiting_[c].find(dut_->out_id_o[c]);
    if (it == waiting_[c].end()) {
      ADD_FAILURE() << "nobody asked";
      return;
    }
    EXPECT_EQ(line_at(dut_->out_data_o[c]), data_of(it->second.line));
    longest = std::max(longest, dut_.cycles() - it->second.since);
    waiting_[c].erase(it);
    ++given;
  }

  void run(long limit) {
    const long start = dut_.cycles();
    longest = 0;
    while (!finished() && dut_.cycles() - start < limit && !HasFailure()) cycle();
    EXPECT_TRUE(finished()) << "lines are missing";
    EXPECT_TRUE(others || dut_->idle_o == 3);
    cycles = dut_.cycles() - start;
  }
  bool finished() const {
    for (unsigned c = 0; c < kCaches; ++c)
      if (!wanted[c].empty() || !waiting_[c].empty()) return false;
    return true;
  }

  struct Waiting {
    line_no_t line;
    long since;
  };
  Dut<Vline_system> dut_;
  std::vector<std::unique_ptr<ReadSub>> subs_;
  std::vector<Gate> source_, sink_;
  std::map<unsigned, Waiting> waiting_[kCaches];
  bool offering_[kCaches] = {};
  unsigned id_[kCaches] = {};

  std::mt19937 rng{5};
  std::deque<line_no_t> wanted[kCaches];
  unsigned contexts = 32;
  bool others = false;
  long cycles = 0, longest = 0, given = 0, l2_hits = 0;
};

TEST_P(LineSystem, GivesEachItsLineWhileEveryChannelStalls) {
  for (const bool loaded : {false, true})
    for (const unsigned range : {40u, 3000u, 1u << 24}) {
      make(GetParam(), 1, 100);
      others = loaded;
      for (auto& lines : wanted)
        for (int i = 0; i < 1000; ++i) lines.push_back(i % 3 == 0 ? rng() % range : rng() % 64);
      run(400000);
      EXPECT_LE(longest, 12000);
    }
}
INSTANTIATE_TEST_SUITE_P(Stalls, LineSystem, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(LineSystem, WhatAHitAndAMissCost) {
  wanted[0] = {8};
  run(300);
  EXPECT_EQ(longest, 81) << "from memory: 60 to the first beat, 3 to the last, 18 here";
  wanted[0] = {8};
  run(300);
  EXPECT_EQ(longest, 4) << "from the cache";
  wanted[1] = {8};
  run(300);
  EXPECT_EQ(longest, 12) << "from the second cache";
  EXPECT_EQ(l2_hits, 1);
}

TEST_F(LineSystem, AllCachesWaitForOneLine) {
  for (auto& lines : wanted) lines.assign(32, 1234);
  run(300);
  EXPECT_EQ(subs_[0]->bursts, 1);
  EXPECT_LE(cycles, 81 + 2 + 32);
}

TEST_F(LineSystem, MissesKeepBothPortsBusy) {
  for (unsigned c = 0; c < kCaches; ++c)
    for (line_no_t i = 0; i < 1000; ++i) wanted[c].push_back(10000 * c + i);
  run(10000);
  EXPECT_LE(cycles, 3000 * 4 / 2 * 102 / 100 + 100) << "four beats a line";
}

}  // namespace
}  // namespace castray::tb
