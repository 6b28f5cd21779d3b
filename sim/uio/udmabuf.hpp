// SPDX-License-Identifier: Apache-2.0
// A buffer of the kernel module u-dma-buf: contiguous, cached by the processor, handed over by its sysfs attributes.
#pragma once
#include "uio/kernel_files.hpp"
#include "uio/shared_memory.hpp"

namespace castray::sim {

class Udmabuf : public SharedMemory {
 public:
  // By name, udmabuf0; empty: the first there is. Throws DeviceError with what to do when there is none.
  Udmabuf(const KernelRoots& roots, const std::string& name);

  std::string name() const override { return name_; }
  std::uint64_t address() const override { return address_; }
  std::uint64_t bytes() const override { return bytes_; }
  void write(std::uint64_t offset, std::span<const std::uint8_t> bytes) override;
  void read(std::uint64_t offset, std::span<std::uint8_t> bytes) override;

 protected:
  enum class Owner { kDevice, kProcessor };
  // Cleans the caches for the device, or drops what they hold for the processor.
  virtual void hand_to(Owner owner, std::uint64_t offset, std::uint64_t bytes);
  std::uint8_t* data() const { return mapping_.data(); }

 private:
  std::filesystem::path attributes_;  // its folder under /sys
  std::string name_;
  std::uint64_t address_;
  std::uint64_t bytes_;
  OpenFile file_;
  Mapping mapping_;
};

}  // namespace castray::sim
