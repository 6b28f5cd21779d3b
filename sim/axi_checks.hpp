// SPDX-License-Identifier: Apache-2.0
// The rules of AXI4 (IHI 0022) that a manager can break, and the core's own: judged cycle by cycle.
//   valid stays, and its payload with it, until ready; no valid in reset
//   INCR bursts of whole 16-byte beats, at most 16 of them, aligned to a beat, inside 4 KiB
//   WLAST with the last beat and only with it; strobes within the burst
//   nothing outside the windows that the job gave: reads by whole beats, writes by strobed bytes
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "axi_ports.hpp"

namespace castray::sim {

struct Window {
  std::uint64_t address = 0;
  std::uint64_t bytes = 0;
  bool readable = false;
  bool writable = false;
};

class AxiChecks {
 public:
  // The windows of the job; without any, every access is a violation.
  void set_windows(std::vector<Window> windows) { windows_ = std::move(windows); }

  // Handshake rules of this cycle against the one before; `ready` are the three of the subordinate.
  void cycle(const AxiManager& manager, const AxiSubordinate& subordinate, std::uint64_t now);
  // True if an untaken valid has to be compared in the next cycle.
  bool watching() const { return ar_waits_ || aw_waits_ || w_waits_; }
  void reset(const AxiManager& manager, std::uint64_t now);

  // An accepted address.
  void burst(const char* channel, const AxiAddress& address, std::uint64_t now);
  // A write beat that belongs to `burst` as number `beat`.
  void beat(const AxiAddress& burst, unsigned beat, const AxiData& data, std::uint64_t now);
  void report(std::uint64_t now, const std::string& what);

  bool allows(std::uint64_t address, std::uint64_t bytes, bool write) const;

  std::uint64_t count() const { return count_; }
  // The first few, each with its cycle.
  const std::vector<std::string>& messages() const { return messages_; }
  void clear() {
    count_ = 0;
    messages_.clear();
  }

 private:
  std::vector<Window> windows_;
  bool ar_waits_ = false;
  bool aw_waits_ = false;
  bool w_waits_ = false;
  AxiAddress ar_;
  AxiAddress aw_;
  AxiData w_;
  std::uint64_t count_ = 0;
  std::vector<std::string> messages_;
};

}  // namespace castray::sim
