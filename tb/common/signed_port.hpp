// SPDX-License-Identifier: Apache-2.0
// Signed numbers on ports: a Verilated port is an unsigned word that holds the lowest bits only.
#pragma once
#include "fixed.hpp"

namespace castray::tb {

template <class Port> void set_signed(Port& port, std::int64_t value, int bits) {
  port = static_cast<Port>(static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << bits) - 1));
}
template <class Port> std::int64_t get_signed(const Port& port, int bits) {
  return wrap_signed(static_cast<std::int64_t>(port), bits);
}

}  // namespace castray::tb
