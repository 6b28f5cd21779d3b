// SPDX-License-Identifier: Apache-2.0
// Bytes that end where memory ends: whoever reads or writes behind them is stopped at once.
#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <new>
#include <span>

namespace castray::tb {

class GuardedBytes {
 public:
  explicit GuardedBytes(std::size_t bytes) : bytes_(bytes) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t held = (bytes + page - 1) / page * page;
    mapped_ = held + 2 * page;
    void* const at = mmap(nullptr, mapped_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED) throw std::bad_alloc();
    base_ = static_cast<std::uint8_t*>(at);
    if (held > 0 && mprotect(base_ + page, held, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
    data_ = base_ + page + held - bytes;
  }
  ~GuardedBytes() { munmap(base_, mapped_); }
  GuardedBytes(const GuardedBytes&) = delete;
  GuardedBytes& operator=(const GuardedBytes&) = delete;

  std::span<std::uint8_t> span() { return {data_, bytes_}; }
  void fill(std::span<const std::uint8_t> from) { std::memcpy(data_, from.data(), from.size()); }

 private:
  std::size_t bytes_, mapped_;
  std::uint8_t *base_, *data_;
};

}  // namespace castray::tb
