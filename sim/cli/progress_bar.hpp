// SPDX-License-Identifier: Apache-2.0
// Progress on stderr: a bar on a terminal, else a line every few seconds.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace castray::cli {

class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();  // ends the bar's line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // cycles == 0: the device counts none.
  void show(double fraction, std::uint64_t cycles);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace castray::cli
