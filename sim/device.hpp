// SPDX-License-Identifier: Apache-2.0
// A castray core behind its registers and its memory, and nothing else: the bit-accurate model, the
// Verilated core, the board. Whoever renders does not know which of them it drives.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

namespace castray::sim {

// The device is not there, is not what this program was built for, or does not come back.
struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A piece of memory that host and core both reach; `address` is what the core sees.
struct Buffer {
  std::uint64_t address = 0;
  std::uint64_t bytes = 0;
};

// How far a job is: 0 to 1, and the cycles it took so far where the device counts any.
using Progress = std::function<void(double fraction, std::uint64_t cycles)>;

enum class Wait {
  kInterrupt,  // the interrupt pin is high
  kHung,       // the core does nothing any more, or not in time
};

class Device {
 public:
  virtual ~Device() = default;

  // One line for people: which device, which build of it.
  virtual std::string description() const = 0;

  // Buffers are aligned to 4096 bytes; new ones hold zeros.
  virtual Buffer allocate(std::uint64_t bytes) = 0;
  virtual void release(const Buffer& buffer) = 0;
  virtual void write(std::uint64_t address, std::span<const std::uint8_t> bytes) = 0;
  virtual void read(std::uint64_t address, std::span<std::uint8_t> bytes) = 0;

  virtual void write_reg(unsigned offset, std::uint32_t value) = 0;
  virtual std::uint32_t read_reg(unsigned offset) = 0;

  virtual Wait wait_interrupt(const Progress& progress) = 0;
  // Back to the state after power-up; memory keeps its contents.
  virtual void reset() = 0;
};

}  // namespace castray::sim
