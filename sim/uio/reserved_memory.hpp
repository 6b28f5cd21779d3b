// SPDX-License-Identifier: Apache-2.0
// Memory that the device tree keeps from the kernel, through /dev/mem: mapped without a cache.
#pragma once
#include "uio/kernel_files.hpp"
#include "uio/shared_memory.hpp"

namespace castray::sim {

class ReservedMemory final : public SharedMemory {
 public:
  // Both are multiples of a page.
  ReservedMemory(const KernelRoots& roots, std::uint64_t address, std::uint64_t bytes);

  std::string name() const override { return file_name_.string(); }
  std::uint64_t address() const override { return address_; }
  std::uint64_t bytes() const override { return bytes_; }
  void write(std::uint64_t offset, std::span<const std::uint8_t> bytes) override;
  void read(std::uint64_t offset, std::span<std::uint8_t> bytes) override;

 private:
  std::filesystem::path file_name_;
  std::uint64_t address_;
  std::uint64_t bytes_;
  OpenFile file_;
  Mapping mapping_;
};

}  // namespace castray::sim
