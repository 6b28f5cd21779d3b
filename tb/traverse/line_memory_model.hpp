// SPDX-License-Identifier: Apache-2.0
// The memory behind a cache of lines: it answers requests in any order, after a delay, with seeded stalls.
#pragma once
#include <functional>
#include <vector>

#include "dut.hpp"

namespace castray::tb {

class LineMemoryModel {
 public:
  using Line = std::function<line_data_t(line_no_t)>;
  LineMemoryModel(Line line, Stalls stalls, unsigned seed, int delay = 20)
      : line_(std::move(line)), sink_(stalls.sink, stalls.burst, seed), source_(stalls.source, stalls.burst, seed + 1), rng_(seed), delay_(delay) {}

  // What is on the ports in this cycle: whether a request is taken, and the fill that is offered.
  bool request_ready() { return ready_ = sink_.open(); }
  const line_fill_t* offered() {
    if (offer_ < 0 && source_.open()) {
      const int first = waiting_.empty() ? 0 : static_cast<int>(rng_() % waiting_.size());
      for (int i = 0; i < static_cast<int>(waiting_.size()) && offer_ < 0; ++i) {
        const int at = (first + i) % static_cast<int>(waiting_.size());
        if (waiting_[static_cast<std::size_t>(at)].due <= now_) offer_ = at;
      }
    }
    return offer_ < 0 ? nullptr : &waiting_[static_cast<std::size_t>(offer_)].fill;
  }
  // What became of it.
  void tick(bool request_valid, const line_req_t& request, bool fill_taken) {
    if (fill_taken) {
      waiting_.erase(waiting_.begin() + offer_);
      offer_ = -1;
    }
    if (request_valid && ready_) {
      Waiting w;
      w.fill.miss = request.miss, w.fill.data = line_(request.line);
      w.due = now_ + 1 + static_cast<long>(rng_() % static_cast<unsigned>(2 * delay_));
      waiting_.push_back(w);
      ++requests;
    }
    ++now_;
  }
  // The two for a unit whose ports are req_* and fill_*.
  template <class V> void drive(Dut<V>& dut) {
    dut->req_ready_i = request_ready();
    const line_fill_t* const fill = offered();
    dut->fill_valid_i = fill != nullptr;
    if (fill) set_port(dut->fill_i, *fill);
  }
  template <class V> void observe(Dut<V>& dut) {
    tick(dut->req_valid_o, get_port<line_req_t>(dut->req_o), dut->fill_valid_i && dut->fill_ready_o);
  }
  long requests = 0;

 private:
  struct Waiting {
    line_fill_t fill;
    long due = 0;
  };
  Line line_;
  Gate sink_, source_;
  std::mt19937 rng_;
  int delay_;
  std::vector<Waiting> waiting_;
  int offer_ = -1;
  bool ready_ = false;
  long now_ = 0;
};

}  // namespace castray::tb
