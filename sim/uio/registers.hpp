// SPDX-License-Identifier: Apache-2.0
// The registers of a core and its interrupt line, however they are reached: mapped from /dev/uioN on the board.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace castray::sim {

enum class Irq {
  kRaised,
  kSilent,  // not in the given time
  kNone,    // there is no line to wait for
};

class Registers {
 public:
  virtual ~Registers() = default;

  virtual std::string name() const = 0;
  virtual std::uint32_t read(unsigned offset) = 0;
  virtual void write(unsigned offset, std::uint32_t value) = 0;
  // Lets the next interrupt through and waits for it, so long at most.
  virtual Irq wait(std::chrono::milliseconds at_most) = 0;
  // Lets time pass, for whoever polls.
  virtual void pause() = 0;
};

}  // namespace castray::sim
