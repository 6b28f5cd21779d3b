// SPDX-License-Identifier: Apache-2.0
// Seeded stalls of the five AXI channels, and the measure of how much they stalled.
#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace castray::sim {

enum Channel : unsigned { kAr, kR, kAw, kW, kB, kChannels };
inline constexpr std::array<const char*, kChannels> kChannelNames{"ar", "r", "aw", "w", "b"};

// A channel is wanted in a cycle in which its transfer would happen but for the stall.
struct StallShare {
  std::uint64_t wanted = 0;
  std::uint64_t blocked = 0;
  double share() const { return wanted ? static_cast<double>(blocked) / static_cast<double>(wanted) : 0; }
};

// Patterns by name:
//   none      nothing is withheld
//   uniform   each channel in each cycle on its own, 45% of the time
//   bursty    the same, in runs of 24 cycles in the mean
//   turn      one channel is shut for 32 to 160 cycles, then another; the other four are open
//   ar r aw w b   only this channel, half of the time, in runs of 24 cycles in the mean
class Stalls {
 public:
  static const std::vector<std::string>& names();

  explicit Stalls(const std::string& name = "none", std::uint64_t seed = 1);

  const std::string& name() const { return name_; }
  bool any() const { return kind_ != Kind::kNone; }
  bool open(Channel channel) const { return open_[channel]; }
  // True for the channels that this pattern ever shuts.
  bool uses(Channel channel) const { return any() && (kind_ != Kind::kOne || channel == only_); }

  // Decides the next cycle.
  void advance();
  // Counts a cycle in which the channel was wanted, and whether it was blocked in it.
  void wanted(Channel channel, bool blocked) {
    ++shares_[channel].wanted;
    shares_[channel].blocked += blocked;
  }
  const std::array<StallShare, kChannels>& shares() const { return shares_; }

 private:
  enum class Kind { kNone, kUniform, kBursty, kTurn, kOne };

  // How long a channel that just opened or shut stays so.
  unsigned run_length();
  void turn();

  std::string name_;
  Kind kind_ = Kind::kNone;
  Channel only_ = kAr;
  std::mt19937_64 random_;
  std::array<bool, kChannels> open_{true, true, true, true, true};
  std::array<unsigned, kChannels> left_{};
  std::array<StallShare, kChannels> shares_{};
};

}  // namespace castray::sim
