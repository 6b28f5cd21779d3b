// SPDX-License-Identifier: Apache-2.0
// A scripted AXI4 manager for judging the memory model: bursts go out as early as the port takes
// them, and everything that comes back is noted with its cycle.
#pragma once
#include <deque>
#include <functional>
#include <vector>

#include "axi_memory.hpp"

namespace castray::tb {

struct ReadBeat {
  std::uint64_t cycle = 0;
  std::uint8_t id = 0;
  std::uint8_t response = 0;
  bool last = false;
  std::uint32_t word = 0;  // the lowest of the beat
  bool operator==(const ReadBeat&) const = default;
};
struct WriteResponse {
  std::uint64_t cycle = 0;
  std::uint8_t id = 0;
  std::uint8_t response = 0;
  bool operator==(const WriteResponse&) const = default;
};

class Manager {
 public:
  explicit Manager(sim::AxiMemory& memory, bool may_skip = true) : memory_(memory), may_skip_(may_skip) {
    now_.r_ready = now_.b_ready = true;
  }

  void read(std::uint64_t address, unsigned beats, std::uint8_t id = 0) {
    ar_.push_back({.address = address, .id = id, .length = static_cast<std::uint8_t>(beats - 1)});
  }
  void write(std::uint64_t address, unsigned beats, std::uint8_t id = 0, std::uint32_t word = 0) {
    aw_.push_back({.address = address, .id = id, .length = static_cast<std::uint8_t>(beats - 1)});
    for (unsigned i = 0; i < beats; ++i) w_.push_back({.data = {word + i, 0, 0, 0}, .strobes = 0xffff, .last = i + 1 == beats});
  }

  // One cycle. `twist` may falsify the signals before the memory sees them.
  void tick(const std::function<void(sim::AxiManager&)>& twist = {}) {
    now_.ar_valid = !ar_.empty();
    now_.aw_valid = !aw_.empty();
    now_.w_valid = !w_.empty();
    if (now_.ar_valid) now_.ar = ar_.front();
    if (now_.aw_valid) now_.aw = aw_.front();
    if (now_.w_valid) now_.w = w_.front();
    sim::AxiManager seen = now_;
    if (twist) twist(seen);
    const sim::AxiSubordinate drive = memory_.drive();
    if (seen.ar_valid && drive.ar_ready) {
      accepted_reads.push_back(cycle);
      if (!ar_.empty()) ar_.pop_front();
    }
    if (seen.aw_valid && drive.aw_ready && !aw_.empty()) aw_.pop_front();
    if (seen.w_valid && drive.w_ready) {
      if (seen.w.last) last_beats.push_back(cycle);
      if (!w_.empty()) w_.pop_front();
    }
    if (drive.r_valid && seen.r_ready) beats.push_back({cycle, drive.r_id, drive.r_response, drive.r_last, drive.r_data[0]});
    if (drive.b_valid && seen.b_ready) responses.push_back({cycle, drive.b_id, drive.b_response});
    if (may_skip_ && memory_.asleep() && !seen.ar_valid && !seen.aw_valid && !seen.w_valid) {
      memory_.skip();
      ++skipped;
    } else {
      memory_.step(seen);
    }
    ++cycle;
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) tick();
  }
  void set_ready(bool r, bool b) {
    now_.r_ready = r;
    now_.b_ready = b;
  }

  std::uint64_t cycle = 0;
  std::uint64_t skipped = 0;
  std::vector<std::uint64_t> accepted_reads;
  std::vector<std::uint64_t> last_beats;
  std::vector<ReadBeat> beats;
  std::vector<WriteResponse> responses;

 private:
  sim::AxiMemory& memory_;
  bool may_skip_;
  sim::AxiManager now_;
  std::deque<sim::AxiAddress> ar_;
  std::deque<sim::AxiAddress> aw_;
  std::deque<sim::AxiData> w_;
};

}  // namespace castray::tb
