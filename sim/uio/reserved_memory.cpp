// SPDX-License-Identifier: Apache-2.0
#include "uio/reserved_memory.hpp"

#include <fcntl.h>

#include "uio/aligned_copy.hpp"

namespace castray::sim {

ReservedMemory::ReservedMemory(const KernelRoots& roots, std::uint64_t address, std::uint64_t bytes)
    : file_name_(roots.dev / "mem"), address_(address), bytes_(bytes), file_(file_name_, O_RDWR | O_SYNC),
      mapping_(file_, file_name_, address, bytes) {}

void ReservedMemory::write(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  copy_out(mapping_.data() + offset, bytes);
}
void ReservedMemory::read(std::uint64_t offset, std::span<std::uint8_t> bytes) { copy_in(bytes, mapping_.data() + offset); }

}  // namespace castray::sim
