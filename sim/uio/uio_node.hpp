// SPDX-License-Identifier: Apache-2.0
// Finds a core among the devices that the kernel hands to programs (UIO).
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "uio/kernel_files.hpp"

namespace castray::sim {

struct UioNode {
  std::filesystem::path file;  // /dev/uio0
  std::string name;            // as the device tree calls it
  std::uint64_t offset = 0;    // of the first register in the mapped pages
};

// The one whose name begins with `wanted`, or, where that holds a slash, the device node of that path. Throws DeviceError
// with what to do when there is none or more than one, when the programmable logic holds no bitstream, or when the
// registers of a core are more than it maps.
UioNode find_uio(const KernelRoots& roots, const std::string& wanted);

}  // namespace castray::sim
