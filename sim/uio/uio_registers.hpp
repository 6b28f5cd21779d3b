// SPDX-License-Identifier: Apache-2.0
// A core's registers as a UIO device maps them.
#pragma once
#include "castray_records.hpp"
#include "uio/interrupt_line.hpp"
#include "uio/kernel_files.hpp"
#include "uio/registers.hpp"
#include "uio/uio_node.hpp"

namespace castray::sim {

inline constexpr std::uint64_t kRegisterBytes = static_cast<std::uint64_t>(RegCounters + 8 * Counters);

class UioRegisters final : public Registers {
 public:
  // Throws DeviceError, also when another program has the device.
  explicit UioRegisters(const UioNode& node);

  std::string name() const override { return node_.file.string() + " (" + node_.name + ")"; }
  std::uint32_t read(unsigned offset) override;
  void write(unsigned offset, std::uint32_t value) override;
  Irq wait(std::chrono::milliseconds at_most) override { return line_.wait(at_most); }
  void pause() override;

 private:
  volatile std::uint32_t* word(unsigned offset) const;

  UioNode node_;
  OpenFile file_;
  Mapping mapping_;
  InterruptLine line_;
};

}  // namespace castray::sim
