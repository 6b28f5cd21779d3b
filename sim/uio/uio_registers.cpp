// SPDX-License-Identifier: Apache-2.0
#include "uio/uio_registers.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "device.hpp"

namespace castray::sim {
namespace {

// All accesses before it have reached memory and device before any behind it begins.
void barrier() {
#ifdef __aarch64__
  asm volatile("dsb sy" ::: "memory");
#else
  std::atomic_thread_fence(std::memory_order_seq_cst);
#endif
}

}  // namespace

UioRegisters::UioRegisters(const UioNode& node)
    : node_(node),
      file_(node.file, O_RDWR | O_SYNC),
      mapping_(file_, node.file, 0, node.offset + kRegisterBytes),
      line_(file_.number()) {
  if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0)
    throw DeviceError(node.file.string() + ": another program uses the core; wait for its end");
}

volatile std::uint32_t* UioRegisters::word(unsigned offset) const {
  return reinterpret_cast<volatile std::uint32_t*>(mapping_.data() + node_.offset + offset);
}

std::uint32_t UioRegisters::read(unsigned offset) {
  const std::uint32_t value = *word(offset);
  barrier();
  return value;
}

void UioRegisters::write(unsigned offset, std::uint32_t value) {
  barrier();
  *word(offset) = value;
}

void UioRegisters::pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

}  // namespace castray::sim
