// SPDX-License-Identifier: Apache-2.0
// Memory as lines whose contents are a function of their number, so that a wrong line is seen.
#pragma once
#include "dut.hpp"

namespace castray::tb {

inline line_data_t data_of(line_no_t line) {
  line_data_t data{};
  for (std::uint32_t i = 0; i < data.size(); ++i) {
    std::uint32_t x = (static_cast<std::uint32_t>(line) * 16 + i) * 2654435761u;
    x ^= x >> 15;
    data[i] = x * 2246822519u;
  }
  return data;
}

// The data on a port.
template <class Port> line_data_t line_at(const Port& port) {
  line_data_t data{};
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = port[i];
  return data;
}

// Cycles from a request to its answer, evenly between the two.
struct Latency {
  int least = 20, most = 20;
  template <class R> long draw(R& rng) const { return least + static_cast<long>(rng() % static_cast<unsigned>(most - least + 1)); }
};

}  // namespace castray::tb
