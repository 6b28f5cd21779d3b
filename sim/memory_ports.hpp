// SPDX-License-Identifier: Apache-2.0
// All memory ports of a core on one memory: each an AxiMemory with timing, stalls and checks of its
// own, and sums over them.
#pragma once
#include <algorithm>
#include <vector>

#include "axi_memory.hpp"

namespace castray::sim {

class MemoryPorts {
 public:
  // The ports' stalls and orders differ: port i takes seed + i.
  MemoryPorts(Storage& storage, const AxiTiming& timing, const std::string& stalls, std::uint64_t seed, int ports) {
    for (int i = 0; i < ports; ++i) ports_.emplace_back(storage, timing, Stalls(stalls, seed + static_cast<unsigned>(i)), seed + static_cast<unsigned>(i));
  }

  std::vector<AxiMemory>::iterator begin() { return ports_.begin(); }
  std::vector<AxiMemory>::iterator end() { return ports_.end(); }
  unsigned count() const { return static_cast<unsigned>(ports_.size()); }
  AxiMemory& operator[](unsigned port) { return ports_[port]; }

  bool idle() const { return std::all_of(ports_.begin(), ports_.end(), [](const AxiMemory& port) { return port.idle(); }); }
  std::uint64_t cycle() const { return ports_[0].cycle(); }
  std::uint64_t last_activity() const {
    std::uint64_t last = 0;
    for (const AxiMemory& port : ports_) last = std::max(last, port.last_activity());
    return last;
  }
  bool stalls_use(Channel channel) const { return ports_[0].stalls().uses(channel); }

  void set_windows(const std::vector<Window>& windows) {
    for (AxiMemory& port : ports_) port.checks().set_windows(windows);
  }
  void set_faults(const std::vector<BusFault>& faults) {
    for (AxiMemory& port : ports_) port.set_faults(faults);
  }
  void clear_counters() {
    for (AxiMemory& port : ports_) port.clear_counters();
  }

  // Sums over the ports; most_reads and most_writes are of the port that had most.
  AxiCounters counters() const {
    AxiCounters sum;
    for (const AxiMemory& port : ports_) sum += port.counters();
    return sum;
  }
  std::array<StallShare, kChannels> shares() const {
    std::array<StallShare, kChannels> sum{};
    for (const AxiMemory& port : ports_)
      for (unsigned i = 0; i < kChannels; ++i) {
        sum[i].wanted += port.stalls().shares()[i].wanted;
        sum[i].blocked += port.stalls().shares()[i].blocked;
      }
    return sum;
  }
  // Rules of the bus that the core broke, and the first of them in words.
  std::uint64_t violations() {
    std::uint64_t count = 0;
    for (AxiMemory& port : ports_) count += port.checks().count();
    return count;
  }
  std::vector<std::string> messages() {
    std::vector<std::string> all;
    for (unsigned i = 0; i < count(); ++i)
      for (const std::string& line : ports_[i].checks().messages()) all.push_back("port " + std::to_string(i) + ", " + line);
    return all;
  }

 private:
  std::vector<AxiMemory> ports_;
};

}  // namespace castray::sim
