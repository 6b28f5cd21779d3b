// SPDX-License-Identifier: Apache-2.0
// The Verilated core behind the AXI memory.
#pragma once
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "core_model.hpp"
#include "device.hpp"

namespace castray::sim {

struct RtlOptions {
  CoreVariant variant;
  std::string cores;                   // the folder of the variants; empty: beside the program
  AxiTiming timing;
  std::string stalls = "none";
  std::uint64_t seed = 1;
  std::uint64_t patience = 2'000'000;  // cycles without any traffic on the bus: the core hangs
  std::string trace_file;              // waveforms of these cycles since power-up, if named
  std::uint64_t trace_first = 0;
  std::uint64_t trace_last = ~std::uint64_t{0};
};

class RtlDevice final : public Device {
 public:
  explicit RtlDevice(const RtlOptions& options = {});

  std::string description() const override;
  Buffer allocate(std::uint64_t bytes) override { return storage_.allocate(bytes); }
  void release(const Buffer& buffer) override { storage_.release(buffer); }
  void write(std::uint64_t address, std::span<const std::uint8_t> bytes) override { storage_.write(address, bytes); }
  void read(std::uint64_t address, std::span<std::uint8_t> bytes) override { storage_.read(address, bytes); }
  void write_reg(unsigned offset, std::uint32_t value) override;
  std::uint32_t read_reg(unsigned offset) override { return core_->read_reg(memory_, offset); }
  Wait wait_interrupt(const Progress& progress) override;
  void reset() override;

  // Memory that someone else owns, at this address: no buffer of the device.
  void attach(std::uint64_t address, std::span<std::uint8_t> bytes) { storage_.attach(address, bytes); }
  // Lets some cycles pass; true if the interrupt is high.
  bool advance(std::uint64_t cycles) { return core_->run(memory_, cycles); }
  std::uint64_t cycle() const { return core_->cycle(); }

  MemoryPorts& memory() { return memory_; }
  // Rules of the bus that the core broke, and what it left undone at the end of a job.
  std::uint64_t violations() { return memory_.violations(); }

 private:
  // The job as the registers stand: its windows are what the core may touch.
  void open_windows();
  double fraction() const;

  RtlOptions options_;
  Storage storage_;
  MemoryPorts memory_;
  std::unique_ptr<CoreModel> core_;
  std::unordered_map<unsigned, std::uint32_t> written_;  // the argument registers
  std::uint64_t bytes_expected_ = 0;                     // of frame and hits
};

}  // namespace castray::sim
