// SPDX-License-Identifier: Apache-2.0
// The interrupt of a UIO device: writing 1 lets the next one through, reading takes it and gives how many there were.
#pragma once
#include <chrono>

#include "uio/registers.hpp"

namespace castray::sim {

class InterruptLine {
 public:
  // An open file that outlives this.
  explicit InterruptLine(int file) : file_(file) {}
  // kNone for good once the kernel says that the device has none.
  Irq wait(std::chrono::milliseconds at_most);

 private:
  int file_;
  bool there_ = true;
};

}  // namespace castray::sim
