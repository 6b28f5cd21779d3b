// SPDX-License-Identifier: Apache-2.0
// Whether a core is of the build that a program was made for.
#pragma once
#include <cstdio>
#include <string>

#include "castray_records.hpp"
#include "device.hpp"

namespace castray::sim {

inline std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", value);
  return text;
}

// read(offset) gives a register. Throws DeviceError unless version and parameters are those of this build.
template <class Read> void check_build(Read&& read) {
  const auto expect = [&](const char* what, std::int64_t reg, std::int64_t expected) {
    const std::uint32_t got = read(static_cast<unsigned>(reg));
    const auto wanted = static_cast<std::uint32_t>(expected);
    if (got != wanted)
      throw DeviceError(std::string("the device's ") + what + " register holds " + hex(got) + ", this program needs " +
                        hex(wanted));
  };
  expect("version", RegVersion, VersionMajor << 16 | VersionMinor << 8 | VersionPatch);
  expect("parameters", RegParameters, ImageParameters);
}

}  // namespace castray::sim
