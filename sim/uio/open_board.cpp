// SPDX-License-Identifier: Apache-2.0
#include "uio/open_board.hpp"

#include <cerrno>
#include <cstdlib>

#include "uio/reserved_memory.hpp"
#include "uio/udmabuf.hpp"
#include "uio/uio_registers.hpp"

namespace castray::sim {
namespace {

// ADDRESS:BYTES, each decimal or 0x, whole pages.
std::pair<std::uint64_t, std::uint64_t> parse_region(const std::string& text) {
  const auto fail = [&] {
    throw DeviceError("--reserved " + text + ": not of the form ADDRESS:BYTES, both multiples of " +
                      std::to_string(FreeSpace::kPage));
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) fail();
  const auto number = [&](const std::string& word) {
    char* end = nullptr;
    errno = 0;
    const std::uint64_t value = std::strtoull(word.c_str(), &end, 0);
    if (word.empty() || word[0] < '0' || word[0] > '9' || *end != '\0' || errno != 0 || value % FreeSpace::kPage != 0) fail();
    return value;
  };
  const std::pair region{number(text.substr(0, colon)), number(text.substr(colon + 1))};
  if (region.second == 0) fail();
  return region;
}

}  // namespace

std::unique_ptr<SharedMemory> open_memory(const BoardOptions& options) {
  if (options.reserved.empty()) return std::make_unique<Udmabuf>(options.roots, options.udmabuf);
  const auto [address, bytes] = parse_region(options.reserved);
  return std::make_unique<ReservedMemory>(options.roots, address, bytes);
}

std::unique_ptr<Device> open_board(const BoardOptions& options) {
  auto registers = std::make_unique<UioRegisters>(find_uio(options.roots, options.uio));
  return std::make_unique<BoardDevice>(std::move(registers), open_memory(options), options.patience);
}

}  // namespace castray::sim
