// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model behind the registers of the core. A job runs when its interrupt is waited for.
#pragma once
#include <array>
#include <map>

#include "core.hpp"
#include "device.hpp"
#include "storage.hpp"

namespace castray::sim {

class ModelDevice final : public Device {
 public:
  // threads == 0: all of the machine. The counters of work are those of a core with tiles of
  // 2^tile_log2 pixels a side.
  explicit ModelDevice(int threads = 0, int tile_log2 = DefaultTileLog2) : threads_(threads), tile_log2_(tile_log2) {}

  std::string description() const override { return "bit-accurate model"; }
  Buffer allocate(std::uint64_t bytes) override { return storage_.allocate(bytes); }
  void release(const Buffer& buffer) override { storage_.release(buffer); }
  void write(std::uint64_t address, std::span<const std::uint8_t> bytes) override { storage_.write(address, bytes); }
  void read(std::uint64_t address, std::span<std::uint8_t> bytes) override { storage_.read(address, bytes); }
  void write_reg(unsigned offset, std::uint32_t value) override;
  std::uint32_t read_reg(unsigned offset) override;
  Wait wait_interrupt(const Progress& progress) override;
  void reset() override;

  // The job that the registers describe, and the windows of memory it may touch: empty
  // where no buffer holds the whole of one.
  job_t job() const;
  Windows windows(const job_t& job);

 private:
  void run(const Progress& progress);

  int threads_;
  int tile_log2_;
  Storage storage_;
  std::map<unsigned, std::uint32_t> registers_;  // arguments, and what they read back as
  bool wanted_ = false;
  bool done_ = false;
  error_t error_ = ErrNone;
  std::array<std::uint64_t, Counters> counts_{};
};

}  // namespace castray::sim
