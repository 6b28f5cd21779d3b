// SPDX-License-Identifier: Apache-2.0
#include "stalls.hpp"

#include <algorithm>
#include <stdexcept>

namespace castray::sim {

const std::vector<std::string>& Stalls::names() {
  static const std::vector<std::string> names{"none", "uniform", "bursty", "turn", "ar", "r", "aw", "w", "b"};
  return names;
}

Stalls::Stalls(const std::string& name, std::uint64_t seed) : name_(name), random_(seed) {
  if (std::find(names().begin(), names().end(), name) == names().end()) throw std::invalid_argument("unknown stall pattern '" + name + "'");
  if (name == "uniform") kind_ = Kind::kUniform;
  if (name == "bursty") kind_ = Kind::kBursty;
  if (name == "turn") kind_ = Kind::kTurn;
  for (unsigned i = 0; i < kChannels; ++i) {
    if (name == kChannelNames[i]) {
      kind_ = Kind::kOne;
      only_ = static_cast<Channel>(i);
    }
  }
}

unsigned Stalls::run_length() { return 1 + static_cast<unsigned>(random_() % 47); }

// Nearly every turn falls to the channel that was blocked least, so that a busy one gets its share.
void Stalls::turn() {
  if (left_[0]-- > 0) return;
  std::size_t next = random_() % kChannels;
  if (random_() % 16 != 0) {
    for (std::size_t i = 0; i < kChannels; ++i)
      if (shares_[i].wanted > 0 && shares_[i].share() < shares_[next].share()) next = i;
  }
  open_.fill(true);
  open_[next] = false;
  left_[0] = 31 + static_cast<unsigned>(random_() % 129);
}

void Stalls::advance() {
  if (kind_ == Kind::kNone) return;
  if (kind_ == Kind::kTurn) return turn();
  if (kind_ == Kind::kUniform) {
    std::uint64_t bits = random_();
    for (bool& open : open_) {
      open = (bits & 0xfff) >= 0x733;  // 45% of 4096
      bits >>= 12;
    }
    return;
  }
  for (unsigned i = 0; i < kChannels; ++i) {
    if (kind_ == Kind::kOne && i != only_) continue;
    if (left_[i]-- > 0) continue;
    open_[i] = !open_[i];
    left_[i] = run_length() - 1;
  }
}

}  // namespace castray::sim
