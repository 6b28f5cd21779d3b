// SPDX-License-Identifier: Apache-2.0
#include "progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace castray::cli {
namespace {
constexpr int kWidth = 30;
constexpr double kBarSeconds = 0.1;
constexpr double kFirstLineSeconds = 2;
constexpr double kLineSeconds = 5;
}  // namespace

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), terminal_(isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
  if (terminal_ && shown_) std::fputc('\n', stderr);
}

void ProgressBar::show(double fraction, std::uint64_t cycles) {
  const auto now = Clock::now();
  const bool last = fraction >= 1;
  const double since = std::chrono::duration<double>(now - last_).count();
  if (since < (terminal_ ? kBarSeconds : shown_ ? kLineSeconds : kFirstLineSeconds) && !(last && terminal_)) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double left = fraction > 0 ? seconds * (1 - fraction) / fraction : 0;
  char figures[120] = "";
  if (cycles > 0)
    std::snprintf(figures, sizeof figures, ", %.1f M cycles, %.2f M cycles/s", static_cast<double>(cycles) / 1e6,
                  static_cast<double>(cycles) / 1e6 / seconds);
  const int percent = static_cast<int>(100 * fraction);
  if (!terminal_) {
    std::fprintf(stderr, "%s: %d%%%s, %.0f s left\n", label_.c_str(), percent, figures, left);
    return;
  }
  const std::string done(static_cast<std::size_t>(std::clamp(static_cast<int>(kWidth * fraction), 0, kWidth)), '#');
  std::fprintf(stderr, "\r%s [%-*s] %3d%%%s, %.0f s left  ", label_.c_str(), kWidth, done.c_str(), percent, figures, left);
}

}  // namespace castray::cli
