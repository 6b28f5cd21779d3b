// SPDX-License-Identifier: Apache-2.0
#include "uio/interrupt_line.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace castray::sim {

Irq InterruptLine::wait(std::chrono::milliseconds at_most) {
  if (!there_) return Irq::kNone;
  const std::uint32_t on = 1;
  there_ = ::write(file_, &on, sizeof on) == sizeof on;
  if (!there_) return Irq::kNone;
  pollfd poll_for{file_, POLLIN, 0};
  const int ready = ::poll(&poll_for, 1, static_cast<int>(at_most.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return Irq::kSilent;
  std::uint32_t count = 0;
  there_ = ready > 0 && ::read(file_, &count, sizeof count) == sizeof count;
  return there_ ? Irq::kRaised : Irq::kNone;
}

}  // namespace castray::sim
