// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/math/root_pipe.sv: integer square root.
#pragma once
#include <cmath>

#include "fixed.hpp"

namespace castray {

// The largest r with r^2 <= rad, for rad < 2^62: the estimate in double is off by one at most.
inline std::uint64_t isqrt(std::uint64_t rad) {
  std::uint64_t root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(rad)));
  if (root * root > rad) return root - 1;
  if ((root + 1) * (root + 1) <= rad) return root + 1;
  return root;
}

}  // namespace castray
