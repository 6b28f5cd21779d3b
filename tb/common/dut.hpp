// SPDX-License-Identifier: Apache-2.0
// A Verilated unit under test: clock, reset, records on ports, and streams with seeded stalls.
#pragma once
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "fixed.hpp"

namespace castray::tb {

// Writes a record (or an integer) to a port of any width, and reads one back.
template <class Port, class Record> void set_port(Port& port, const Record& record) {
  if constexpr (std::is_integral_v<Record>) {
    port = static_cast<Port>(record);
  } else {
    const auto words = pack(record);
    if constexpr (std::is_integral_v<Port>) {
      std::uint64_t value = words[0];
      if constexpr (words.size() > 1) value |= std::uint64_t{words[1]} << 32;
      port = static_cast<Port>(value);
    } else {
      for (std::size_t i = 0; i < words.size(); ++i) port[i] = words[i];
    }
  }
}
template <class Record, class Port> Record get_port(const Port& port) {
  if constexpr (std::is_integral_v<Record>) {
    return static_cast<Record>(port);
  } else {
    packed_t<Record> words{};
    if constexpr (std::is_integral_v<Port>) {
      for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint32_t>(std::uint64_t{port} >> (32 * i));
    } else {
      for (std::size_t i = 0; i < words.size(); ++i) words[i] = port[i];
    }
    return unpack<Record>(words.data());
  }
}

// Owns the model, the clock and the reset. Inputs are driven while the clock is low; outputs are
// sampled after eval() and before the rising edge: tick() does one whole cycle.
template <class V> class Dut {
 public:
  explicit Dut(unsigned seed = 1) {
    context_->randReset(2);
    context_->randSeed(static_cast<int>(seed));
    top_ = std::make_unique<V>(context_.get());
    top_->clk_i = 0;
    reset();
  }
  ~Dut() { top_->final(); }

  V* operator->() { return top_.get(); }

  // Lets combinational outputs follow the inputs of this cycle.
  void settle() { top_->eval(); }

  void tick() {
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
    top_->clk_i = 0;
    top_->eval();
    ++cycles_;
    context_->timeInc(1);
  }

  void reset(int cycles = 4) {
    if constexpr (requires(V& v) { v.rst_ni; }) {
      top_->rst_ni = 0;
      for (int i = 0; i < cycles; ++i) tick();
      top_->rst_ni = 1;
    }
    top_->eval();
  }

  long cycles() const { return cycles_; }

 private:
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<V> top_;
  long cycles_ = 0;
};

// How often a stream's valid or ready is withheld.
struct Stalls {
  const char* name = "none";
  double source = 0;  // chance that a source offers nothing in a cycle
  double sink = 0;    // chance that a sink is not ready
  int burst = 1;      // mean length of a run of equal decisions, cycles
};
inline const Stalls kStallPatterns[] = {
    {"none", 0, 0, 1},
    {"source", 0.5, 0, 1},
    {"sink", 0, 0.5, 1},
    {"uniform", 0.4, 0.4, 1},
    {"bursty", 0.5, 0.5, 16},
};
inline void PrintTo(const Stalls& stalls, std::ostream* os) { *os << stalls.name; }

// A seeded yes/no that keeps its answer for `burst` cycles in the mean.
class Gate {
 public:
  Gate(double blocked, int burst, unsigned seed) : blocked_(blocked), burst_(burst), rng_(seed) {}
  bool open() {
    if (blocked_ <= 0) return true;
    if (uniform_(rng_) < 1.0 / burst_) open_ = uniform_(rng_) >= blocked_;
    return open_;
  }

 private:
  double blocked_;
  int burst_;
  std::mt19937 rng_;
  std::uniform_real_distribution<double> uniform_{0, 1};
  bool open_ = true;
};

// Sends `inputs` into ports in_valid_i/in_ready_o/in_i and collects out_valid_o/out_ready_i/out_o
// until `expected` results came or `limit` cycles passed; checks that an untaken item is held.
template <class Out, class V, class In>
std::vector<Out> run_stream(Dut<V>& dut, const std::vector<In>& inputs, std::size_t expected, Stalls stalls = {},
                            unsigned seed = 1, long limit = 0) {
  if (limit == 0) limit = 2000 + 64L * static_cast<long>(std::max(inputs.size(), expected));
  Gate source(stalls.source, stalls.burst, seed), sink(stalls.sink, stalls.burst, seed + 1);
  std::vector<Out> outputs;
  std::size_t sent = 0;
  bool offering = false;
  bool held = false;
  Out held_item{};
  for (long cycle = 0; cycle < limit && (outputs.size() < expected || sent < inputs.size()); ++cycle) {
    if (!offering && sent < inputs.size()) offering = source.open();
    dut->in_valid_i = offering;
    if (offering) set_port(dut->in_i, inputs[sent]);
    dut->out_ready_i = sink.open();
    dut.settle();
    if (dut->out_valid_o) {
      const Out item = get_port<Out>(dut->out_o);
      if (held) EXPECT_TRUE(item == held_item) << "an untaken item changed";
      held = !dut->out_ready_i;
      held_item = item;
      if (dut->out_ready_i) outputs.push_back(item);
    } else {
      EXPECT_FALSE(held) << "an untaken item was dropped";
      held = false;
    }
    if (offering && dut->in_ready_o) {
      ++sent;
      offering = false;
    }
    dut.tick();
  }
  dut->in_valid_i = 0;
  dut->out_ready_i = 0;
  EXPECT_EQ(sent, inputs.size()) << "inputs not taken within the limit of cycles";
  return outputs;
}

}  // namespace castray::tb
