// SPDX-License-Identifier: Apache-2.0
// The memory with a buffer whose words count up, behind a scripted manager.
#pragma once
#include <gtest/gtest.h>

#include "axi_manager.hpp"

namespace castray::tb {

using sim::AxiManager;
using sim::AxiMemory;
using sim::AxiTiming;
using sim::Stalls;

struct Bench {
  explicit Bench(const AxiTiming& timing = {}, const std::string& pattern = "none", bool may_skip = true, unsigned seed = 7)
      : memory(storage, timing, Stalls(pattern, seed), seed), manager(memory, may_skip) {
    buffer = storage.allocate(65536);
    std::vector<std::uint8_t> bytes(buffer.bytes);
    for (std::size_t i = 0; i < bytes.size(); i += 16) {
      bytes[i] = static_cast<std::uint8_t>(i >> 4);
      bytes[i + 1] = static_cast<std::uint8_t>(i >> 12);
    }
    storage.write(buffer.address, bytes);
    memory.checks().set_windows({{buffer.address, buffer.bytes, true, true}});
  }
  std::uint64_t at(std::uint64_t offset) const { return buffer.address + offset; }
  std::string first_message() { return memory.checks().messages().empty() ? "" : memory.checks().messages()[0]; }

  sim::Storage storage;
  sim::Buffer buffer;
  AxiMemory memory;
  Manager manager;
};

}  // namespace castray::tb
