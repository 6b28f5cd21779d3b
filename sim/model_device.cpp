// SPDX-License-Identifier: Apache-2.0
#include "model_device.hpp"

#include "axi/axi_lite_regs.hpp"
#include "mem/image.hpp"

namespace castray::sim {
namespace {
constexpr std::uint32_t bit(std::int64_t number) { return std::uint32_t{1} << number; }
}  // namespace

void ModelDevice::write_reg(unsigned offset, std::uint32_t value) {
  if (offset == RegControl) {
    if (value & bit(CtrlStart)) wanted_ = true;
  } else if (offset == RegIsr) {
    registers_[RegIsr] ^= value & (bit(IsrDone) | bit(IsrReady));
  } else if (offset < RegVersion || (offset >= RegRays && offset < RegCounters)) {
    registers_[offset] = value;
  }
}

std::uint32_t ModelDevice::read_reg(unsigned offset) {
  const unsigned counters_end = RegCounters + 8 * Counters;
  if (offset >= RegCounters && offset < counters_end) {
    const std::uint64_t count = counts_[(offset - RegCounters) / 8];
    return static_cast<std::uint32_t>(offset % 8 == 0 ? count : count >> 32);
  }
  switch (offset) {
    case RegControl: {
      const bool interrupt = registers_[RegGie] && registers_[RegIsr];
      const std::uint32_t value = (wanted_ ? bit(CtrlStart) : bit(CtrlIdle)) |
                                  (done_ ? bit(CtrlDone) | bit(CtrlReady) : 0) | (interrupt ? bit(CtrlInterrupt) : 0);
      done_ = false;
      return value;
    }
    case RegVersion: return VersionMajor << 16 | VersionMinor << 8 | VersionPatch;
    case RegConfig: return 0;  // no lanes, no contexts, no tiles
    case RegParameters: return static_cast<std::uint32_t>(ImageParameters);
    case RegError: return static_cast<std::uint32_t>(error_);
  }
  const auto found = registers_.find(offset);
  return found == registers_.end() ? 0 : found->second;
}

job_t ModelDevice::job() const {
  return job_of_registers([&](unsigned offset) {
    const auto found = registers_.find(offset);
    return found == registers_.end() ? 0 : found->second;
  });
}

Windows ModelDevice::windows(const job_t& job) {
  const auto span = [&](std::uint64_t address, std::uint64_t bytes) {
    std::uint8_t* data = storage_.find(address, bytes);
    return std::span<std::uint8_t>(data, data ? bytes : 0);
  };
  const std::span<std::uint8_t> none;
  return {.image = span(job.image, job.image_bytes),
          .frame = job.is_list ? none : span(job.frame, job.frame_bytes),
          .hits = job.want_hits ? span(job.hits, job.hits_bytes) : none,
          .rays = job.is_list ? span(job.rays, job.ray_bytes) : none};
}

void ModelDevice::run(const Progress& progress) {
  const job_t job = this->job();
  const Windows windows = this->windows(job);
  counts_ = {};
  error_ = check_image(windows.image.data(), windows.image.size(), job);
  if (error_ != ErrNone) return;
  const bool hits_missing = job.want_hits && windows.hits.size() < job.hits_bytes;
  const bool frame_missing = !job.is_list && windows.frame.size() < job.frame_bytes;
  if (job.is_list && windows.rays.size() < job.ray_bytes) error_ = ErrReadBus;
  else if (frame_missing || hits_missing) error_ = ErrWriteBus;
  if (error_ != ErrNone) return;
  const auto on_progress = [&](double fraction) {
    if (progress) progress(fraction, 0);
  };
  const Outcome outcome = run_job(job, windows, {tile_log2_, threads_, on_progress});
  error_ = outcome.error;
  for (const auto& [index, count] : kWorkCounters) counts_[static_cast<std::size_t>(index)] = outcome.counters.*count;
}

Wait ModelDevice::wait_interrupt(const Progress& progress) {
  if (!wanted_) return registers_[RegGie] && registers_[RegIsr] ? Wait::kInterrupt : Wait::kHung;
  run(progress);
  wanted_ = false;
  done_ = true;
  registers_[RegIsr] |= registers_[RegIer] & (bit(IsrDone) | bit(IsrReady));
  return registers_[RegGie] && registers_[RegIsr] ? Wait::kInterrupt : Wait::kHung;
}

void ModelDevice::reset() {
  registers_.clear();
  wanted_ = done_ = false;
  error_ = ErrNone;
  counts_ = {};
}

}  // namespace castray::sim
