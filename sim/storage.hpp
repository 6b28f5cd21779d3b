// SPDX-License-Identifier: Apache-2.0
// The bytes behind a simulated device: buffers by address, with unmapped pages between them so that
// an access past the end of one never lands in the next.
#pragma once
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

#include "device.hpp"

namespace castray::sim {

class Storage {
 public:
  static constexpr std::uint64_t kPage = 4096;

  // Buffers start above 4 GiB: a core that drops the upper half of a pointer fails at once.
  explicit Storage(std::uint64_t base = 0x12'3450'0000) : next_(base) {}

  Buffer allocate(std::uint64_t bytes) {
    const Buffer buffer{next_, bytes};
    Piece& piece = buffers_[next_];
    piece.own.resize(bytes);
    piece.bytes = piece.own;
    next_ += (bytes + 2 * kPage - 1) / kPage * kPage + kPage;
    last_ = {};
    return buffer;
  }

  // Bytes that stay someone else's, as memory of this address; no buffer lies there.
  void attach(std::uint64_t address, std::span<std::uint8_t> bytes) {
    buffers_[address].bytes = bytes;
    last_ = {};
  }

  void release(const Buffer& buffer) {
    buffers_.erase(buffer.address);
    last_ = {};
  }

  // Where [address, address + bytes) lies on the host, null unless one buffer holds all of it.
  std::uint8_t* find(std::uint64_t address, std::uint64_t bytes) {
    if (address - last_.first > last_.bytes || bytes > last_.bytes - (address - last_.first)) {
      auto it = buffers_.upper_bound(address);
      if (it == buffers_.begin()) return nullptr;
      --it;
      const std::uint64_t size = it->second.bytes.size();
      if (address - it->first > size || bytes > size - (address - it->first)) return nullptr;
      last_ = {it->first, size, it->second.bytes.data()};
    }
    return last_.data + (address - last_.first);
  }

  void write(std::uint64_t address, std::span<const std::uint8_t> bytes) {
    std::memcpy(at(address, bytes.size()), bytes.data(), bytes.size());
  }
  void read(std::uint64_t address, std::span<std::uint8_t> bytes) {
    std::memcpy(bytes.data(), at(address, bytes.size()), bytes.size());
  }

 private:
  struct Piece {
    std::vector<std::uint8_t> own;
    std::span<std::uint8_t> bytes;
  };
  struct Last {
    std::uint64_t first = 0;
    std::uint64_t bytes = 0;
    std::uint8_t* data = nullptr;
  };

  std::uint8_t* at(std::uint64_t address, std::uint64_t bytes) {
    std::uint8_t* data = find(address, bytes);
    if (!data) throw std::out_of_range("the host touches device memory that was never allocated");
    return data;
  }

  std::map<std::uint64_t, Piece> buffers_;
  std::uint64_t next_;
  Last last_;
};

}  // namespace castray::sim
