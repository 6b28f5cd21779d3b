// SPDX-License-Identifier: Apache-2.0
#include "rtl_device.hpp"

#include <algorithm>

#include "axi/axi_lite_regs.hpp"
#include "job_windows.hpp"
#include "probe.hpp"

namespace castray::sim {
namespace {
constexpr std::uint64_t kChunk = 1 << 16;  // cycles between two looks at progress
constexpr unsigned kResetCycles = 8;
}  // namespace

RtlDevice::RtlDevice(const RtlOptions& options)
    : options_(options), memory_(storage_, options.timing, options.stalls, options.seed, options.variant.ports),
      core_(make_core(options.variant, options.seed, !options.trace_file.empty(), options.cores)) {
  if (!options.trace_file.empty()) core_->trace(options.trace_file, options.trace_first, options.trace_last);
  reset();
}

std::string RtlDevice::description() const {
  std::string text = "Verilated core, " + text_of(options_.variant) + "; memory " + options_.timing.name;
  if (options_.stalls != "none") text += ", stalls " + options_.stalls + ", seed " + std::to_string(options_.seed);
  return text;
}

void RtlDevice::reset() {
  const Probe::Muted muted;
  core_->reset(memory_, kResetCycles);
  written_.clear();
  memory_.set_windows({});
}

void RtlDevice::write_reg(unsigned offset, std::uint32_t value) {
  if (offset == RegControl && (value >> CtrlStart & 1)) open_windows();
  written_[offset] = value;
  core_->write_reg(memory_, offset, value);
}

void RtlDevice::open_windows() {
  const job_t job = job_of_registers([&](unsigned offset) { return written_[offset]; });
  std::vector<Window> windows;
  for (const JobWindow& window : windows_of(job)) windows.push_back({window.address, window.bytes, !window.written, window.written});
  memory_.set_windows(windows);
  memory_.clear_counters();
  bytes_expected_ = bytes_written(job);
}

double RtlDevice::fraction() const {
  if (bytes_expected_ == 0) return 0;
  return std::min(1.0, static_cast<double>(memory_.counters().bytes_written) / static_cast<double>(bytes_expected_));
}

Wait RtlDevice::wait_interrupt(const Progress& progress) {
  const std::uint64_t first = core_->cycle();
  const std::uint64_t first_quiet = memory_.cycle();
  while (!core_->run(memory_, kChunk)) {
    if (progress) progress(fraction(), core_->cycle() - first);
    if (memory_.cycle() - std::max(first_quiet, memory_.last_activity()) > options_.patience) return Wait::kHung;
  }
  if (progress) progress(fraction(), core_->cycle() - first);
  if (!memory_.idle()) memory_[0].checks().report(memory_.cycle(), "the job ended with transfers unanswered");
  return Wait::kInterrupt;
}

}  // namespace castray::sim
