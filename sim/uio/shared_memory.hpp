// SPDX-License-Identifier: Apache-2.0
// A physically contiguous piece of memory that host and core both reach.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace castray::sim {

class SharedMemory {
 public:
  virtual ~SharedMemory() = default;

  virtual std::string name() const = 0;
  virtual std::uint64_t address() const = 0;  // as the core sees it
  virtual std::uint64_t bytes() const = 0;
  // What was written, the core sees; what is read, the core wrote, whatever a cache holds.
  virtual void write(std::uint64_t offset, std::span<const std::uint8_t> bytes) = 0;
  virtual void read(std::uint64_t offset, std::span<std::uint8_t> bytes) = 0;
};

}  // namespace castray::sim
