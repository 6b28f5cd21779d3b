// SPDX-License-Identifier: Apache-2.0
// The core of this board, as the kernel shows it.
#pragma once
#include <memory>
#include <string>

#include "uio/board_device.hpp"
#include "uio/kernel_files.hpp"

namespace castray::sim {

struct BoardOptions {
  std::string uio = "castray";  // the device's name begins so; with a slash: its device node
  std::string udmabuf;          // the buffer's name; empty: the first there is
  std::string reserved;         // ADDRESS:BYTES of memory that the device tree reserves, instead of such a buffer
  BoardPatience patience;
  KernelRoots roots;
};

// Throw DeviceError with one line of what is missing and what to do.
std::unique_ptr<SharedMemory> open_memory(const BoardOptions& options);
std::unique_ptr<Device> open_board(const BoardOptions& options);

}  // namespace castray::sim
