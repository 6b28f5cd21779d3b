// SPDX-License-Identifier: Apache-2.0
// A Verilated class of castray_core behind CoreModel. A cycle: drive with the clock low, evaluate,
// let the memory see the settled outputs, raise the clock.
#pragma once
#include <verilated.h>
#include <verilated_fst_c.h>

#include <stdexcept>

#include "fixed.hpp"
#include "core_model.hpp"

namespace castray::sim {

// A port's field of a signal that holds `width` bits for each port: up to 64 bits in all an integer,
// else an array of 32-bit words.
template <class Signal> std::uint64_t field(const Signal& signal, unsigned port, unsigned width) {
  const unsigned low = port * width;
  std::uint64_t bits;
  if constexpr (std::is_integral_v<Signal>) {
    bits = std::uint64_t{signal} >> low;
  } else {
    const unsigned word = low / 32, shift = low % 32;
    bits = (signal[word] | std::uint64_t{signal[word + 1]} << 32) >> shift;
  }
  return bits & ((std::uint64_t{1} << width) - 1);
}
template <class Signal> void set_field(Signal& signal, unsigned port, unsigned width, unsigned value) {
  const unsigned low = port * width, mask = ((1u << width) - 1) << low;
  signal = static_cast<Signal>((signal & ~mask) | value << low);
}

template <class V> class CoreInstance final : public CoreModel {
 public:
  explicit CoreInstance(std::uint64_t seed) {
    context_->randReset(2);
    context_->randSeed(static_cast<int>(seed % 0x7fffffff));
    context_->traceEverOn(true);
    top_ = std::make_unique<V>(context_.get());
    top_->clk_i = 0;
    top_->rst_ni = 0;
    lite_idle();
    put(0, {});
  }
  ~CoreInstance() override {
    if (fst_) fst_->close();
    top_->final();
    Verilated::threadContextp(context_.get());  // the model's destructor asks for it; another core's may be gone
  }

  bool run(MemoryPorts& memory, std::uint64_t cycles) override {
    while (cycles > 0) {
      const std::uint64_t some = std::min(cycles, until_trace_changes());
      if (tracing() ? run_some<true>(memory, some) : run_some<false>(memory, some)) return true;
      cycles -= some;
    }
    return false;
  }

  void write_reg(MemoryPorts& memory, unsigned offset, std::uint32_t value) override {
    V& v = *top_;
    v.s_axi_awvalid_i = v.s_axi_wvalid_i = 1;
    v.s_axi_awaddr_i = static_cast<std::uint16_t>(offset);
    v.s_axi_wdata_i = value;
    v.s_axi_wstrb_i = 0xf;
    v.s_axi_bready_i = 1;
    access(memory, "write", offset, [&] {
      const bool address = v.s_axi_awvalid_i && v.s_axi_awready_o;
      const bool data = v.s_axi_wvalid_i && v.s_axi_wready_o;
      const bool done = v.s_axi_bvalid_o;
      return [&v, address, data, done] {
        if (address) v.s_axi_awvalid_i = 0;
        if (data) v.s_axi_wvalid_i = 0;
        return done;
      };
    });
  }

  std::uint32_t read_reg(MemoryPorts& memory, unsigned offset) override {
    V& v = *top_;
    v.s_axi_arvalid_i = 1;
    v.s_axi_araddr_i = static_cast<std::uint16_t>(offset);
    v.s_axi_rready_i = 1;
    std::uint32_t value = 0;
    access(memory, "read", offset, [&] {
      const bool address = v.s_axi_arvalid_i && v.s_axi_arready_o;
      const bool done = v.s_axi_rvalid_o;
      if (done) value = v.s_axi_rdata_o;
      return [&v, address, done] {
        if (address) v.s_axi_arvalid_i = 0;
        return done;
      };
    });
    return value;
  }

  void reset(MemoryPorts& memory, unsigned cycles) override {
    context_->assertOn(false);  // registers without reset may hold anything until its first edge
    top_->rst_ni = 0;
    lite_idle();
    for (unsigned i = 0; i < cycles; ++i) {
      for (unsigned port = 0; port < memory.count(); ++port) put(port, memory[port].drive());
      top_->clk_i = 0;
      top_->eval();
      dump();
      for (unsigned port = 0; port < memory.count(); ++port) memory[port].reset(i == 0 ? AxiManager{} : signals(port));
      edge<true>(memory);
    }
    top_->rst_ni = 1;
    context_->assertOn(true);
  }

  bool has_waves() const override { return kWaves; }

  void trace(const std::string& file, std::uint64_t first, std::uint64_t last) override {
    trace_file_ = file;
    trace_first_ = first;
    trace_last_ = last;
  }

  std::uint64_t cycle() const override { return cycle_; }

 private:
  static constexpr bool kWaves = requires(V& top, VerilatedFstC* fst) { top.trace(fst, 99); };

  // ---- Signals ----
  void lite_idle() {
    V& v = *top_;
    v.s_axi_awvalid_i = v.s_axi_wvalid_i = v.s_axi_bready_i = v.s_axi_arvalid_i = v.s_axi_rready_i = 0;
  }

  // What the memory drives on a port.
  void put(unsigned port, const AxiSubordinate& s) {
    V& v = *top_;
    set_field(v.m_axi_arready_i, port, 1, s.ar_ready);
    set_field(v.m_axi_awready_i, port, 1, s.aw_ready);
    set_field(v.m_axi_wready_i, port, 1, s.w_ready);
    set_field(v.m_axi_rvalid_i, port, 1, s.r_valid);
    set_field(v.m_axi_rid_i, port, 4, s.r_id);
    set_field(v.m_axi_rresp_i, port, 2, s.r_response);
    set_field(v.m_axi_rlast_i, port, 1, s.r_last);
    for (unsigned i = 0; i < 4; ++i) v.m_axi_rdata_i[4 * port + i] = s.r_data[i];
    set_field(v.m_axi_bvalid_i, port, 1, s.b_valid);
    set_field(v.m_axi_bid_i, port, 4, s.b_id);
    set_field(v.m_axi_bresp_i, port, 2, s.b_response);
  }

  // What the core drives on a port.
  AxiManager signals(unsigned port) const {
    V& v = *top_;
    AxiManager m;
    m.ar_valid = v.m_axi_arvalid_o >> port & 1;
    m.aw_valid = v.m_axi_awvalid_o >> port & 1;
    m.w_valid = v.m_axi_wvalid_o >> port & 1;
    m.r_ready = v.m_axi_rready_o >> port & 1;
    m.b_ready = v.m_axi_bready_o >> port & 1;
    if (m.ar_valid)
      m.ar = {field(v.m_axi_araddr_o, port, AddrW), byte(v.m_axi_arid_o, port, 4), byte(v.m_axi_arlen_o, port, 8),
              byte(v.m_axi_arsize_o, port, 3), byte(v.m_axi_arburst_o, port, 2), byte(v.m_axi_arcache_o, port, 4)};
    if (m.aw_valid)
      m.aw = {field(v.m_axi_awaddr_o, port, AddrW), byte(v.m_axi_awid_o, port, 4), byte(v.m_axi_awlen_o, port, 8),
              byte(v.m_axi_awsize_o, port, 3), byte(v.m_axi_awburst_o, port, 2), byte(v.m_axi_awcache_o, port, 4)};
    if (m.w_valid) {
      for (unsigned i = 0; i < 4; ++i) m.w.data[i] = v.m_axi_wdata_o[4 * port + i];
      m.w.strobes = static_cast<std::uint16_t>(field(v.m_axi_wstrb_o, port, kBeatBytes));
      m.w.last = v.m_axi_wlast_o >> port & 1;
    }
    return m;
  }
  template <class Signal> static std::uint8_t byte(const Signal& signal, unsigned port, unsigned width) {
    return static_cast<std::uint8_t>(field(signal, port, width));
  }

  // ---- Cycles ----
  template <bool kTrace> bool run_some(MemoryPorts& memory, std::uint64_t cycles) {
    V& v = *top_;
    for (; cycles > 0; --cycles) {
      settle<kTrace>(memory);
      edge<kTrace>(memory);
      if (v.irq_o) return true;
    }
    return false;
  }

  template <bool kTrace> void settle(MemoryPorts& memory) {
    V& v = *top_;
    for (unsigned port = 0; port < memory.count(); ++port)
      if (memory[port].moved()) put(port, memory[port].drive());
    v.clk_i = 0;
    v.eval();
    if (kTrace) dump();
    const auto offered = v.m_axi_arvalid_o | v.m_axi_awvalid_o | v.m_axi_wvalid_o;
    for (unsigned port = 0; port < memory.count(); ++port) {
      if (memory[port].asleep() && !(offered >> port & 1)) memory[port].skip();
      else memory[port].step(signals(port));
    }
  }

  template <bool kTrace> void edge(MemoryPorts&) {
    top_->clk_i = 1;
    top_->eval();
    ++cycle_;
    if (kTrace) dump();
  }

  // sample() looks at the settled ports and returns what to do after the edge: true ends the access.
  template <class Sample> void access(MemoryPorts& memory, const char* what, unsigned offset, Sample&& sample) {
    for (int i = 0; i < 1000; ++i) {
      settle<true>(memory);
      const auto after = sample();
      edge<true>(memory);
      if (after()) return lite_idle();
    }
    throw std::runtime_error("the core does not answer the " + std::string(what) + " of register " + std::to_string(offset));
  }

  // ---- Waveforms ----
  bool tracing() const { return cycle_ >= trace_first_ && cycle_ < trace_last_; }
  std::uint64_t until_trace_changes() const {
    if (cycle_ < trace_first_) return trace_first_ - cycle_;
    return cycle_ < trace_last_ ? trace_last_ - cycle_ : ~std::uint64_t{0};
  }
  void dump() {
    if (!tracing()) {
      if (fst_ && cycle_ >= trace_last_) {
        fst_->close();
        fst_.reset();
      }
      return;
    }
    if (!fst_) {
      fst_ = std::make_unique<VerilatedFstC>();
      if constexpr (kWaves) top_->trace(fst_.get(), 99);
      fst_->open(trace_file_.c_str());
      if (!fst_->isOpen()) throw std::runtime_error(trace_file_ + ": cannot write the waveforms");
    }
    fst_->dump(2 * cycle_ + (top_->clk_i ? 0 : 1));
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<V> top_;
  std::unique_ptr<VerilatedFstC> fst_;
  std::string trace_file_;
  std::uint64_t trace_first_ = 0;
  std::uint64_t trace_last_ = 0;
  std::uint64_t cycle_ = 0;
};

}  // namespace castray::sim
