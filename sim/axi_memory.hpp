// SPDX-License-Identifier: Apache-2.0
// The memory behind one AXI4 port of the core: timing, stalls, errors, and the rules it watches over.
//
// The first beat of a read comes `latency` cycles after its address was taken, a write's response as
// many cycles after its last beat; requests overlap; one read beat and one write beat a cycle. With
// a seed for order, responses of different IDs overtake each other and read bursts interleave.
//
// step() is called once a cycle with the settled signals of the core and decides what the memory
// drives in the next. While asleep() and the core offers nothing, skip() does for step().
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "axi_checks.hpp"
#include "axi_ports.hpp"
#include "stalls.hpp"
#include "storage.hpp"

namespace castray::sim {

// How the memory answers: `reference`, or `hp` with 8 requests outstanding, as a port of the board's
// processor takes. Every published figure says which.
struct AxiTiming {
  std::string name = "reference";
  unsigned latency = 60;
  unsigned outstanding = 64;  // reads, and as many writes
  bool reorder = false;       // between IDs, by the seed

  static AxiTiming named(const std::string& name);  // reference, hp; throws std::invalid_argument
};

// Accesses of this range get an error response.
struct BusFault {
  std::uint64_t address = 0;
  std::uint64_t bytes = 0;
  AxiResponse response = kSlvErr;
};

struct AxiCounters {
  std::uint64_t reads = 0;
  std::uint64_t read_beats = 0;
  std::uint64_t writes = 0;
  std::uint64_t write_beats = 0;
  std::uint64_t bytes_written = 0;  // strobed
  std::uint64_t errors = 0;         // error responses given
  std::uint64_t reordered = 0;      // responses given before an older one of another ID
  std::uint64_t dropped = 0;        // bursts in flight when the reset came
  unsigned most_reads = 0;          // outstanding at once
  unsigned most_writes = 0;

  AxiCounters& operator+=(const AxiCounters& other);
};

class AxiMemory {
 public:
  AxiMemory(Storage& storage, AxiTiming timing, Stalls stalls, std::uint64_t seed = 1);

  const AxiSubordinate& drive() const { return drive_; }
  // True if the outputs may differ from those of the cycle before.
  bool moved() const { return moved_; }
  bool asleep() const { return cycle_ < wake_; }
  void skip() {
    ++cycle_;
    moved_ = false;
  }
  void step(const AxiManager& manager);
  // A cycle in reset, after the first clock edge in it: what is in flight is lost, the bytes stay.
  void reset(const AxiManager& manager);

  void set_faults(std::vector<BusFault> faults) { faults_ = std::move(faults); }
  // Nothing accepted is unanswered.
  bool idle() const { return open_reads() == 0 && open_writes() == 0 && !drive_.r_valid && beats_.empty(); }
  // The last cycle in which an address or a beat was taken.
  std::uint64_t last_activity() const { return last_activity_; }
  std::uint64_t cycle() const { return cycle_; }

  AxiChecks& checks() { return checks_; }
  const AxiCounters& counters() const { return counters_; }
  void clear_counters() { counters_ = {}; }
  const Stalls& stalls() const { return stalls_; }
  const AxiTiming& timing() const { return timing_; }

 private:
  struct Read {
    AxiAddress address;
    unsigned done = 0;
    std::uint64_t due = 0;
  };
  struct Write {
    AxiAddress address;
    unsigned done = 0;
    AxiResponse response = kOkay;
  };
  struct Response {
    std::uint8_t id = 0;
    AxiResponse response = kOkay;
    std::uint64_t due = 0;
  };

  // Accepted and not wholly answered, the answer that is on the port included.
  std::size_t open_reads() const { return reads_.size() + (drive_.r_valid && drive_.r_last); }
  std::size_t open_writes() const { return writes_.size() + responses_.size() + drive_.b_valid; }

  void take_addresses(const AxiManager& manager);
  void take_data(const AxiManager& manager);
  void store(Write& write, const AxiData& data);
  void drive_reads();
  void drive_responses();
  void read_beat(const Read& read);
  AxiResponse response_at(std::uint64_t address) const;
  void sleep_until_next();
  // Which of a queue may answer now: the oldest, or with reorder any that is the oldest of its ID.
  template <class Queue> std::optional<std::size_t> pick(const Queue& queue, std::uint64_t now);

  Storage* storage_;
  AxiTiming timing_;
  Stalls stalls_;
  std::mt19937_64 random_;
  AxiChecks checks_;
  std::vector<BusFault> faults_;
  AxiCounters counters_;
  AxiSubordinate drive_;
  bool moved_ = true;
  std::uint64_t cycle_ = 0;
  std::uint64_t wake_ = 0;
  std::uint64_t last_activity_ = 0;
  std::deque<Read> reads_;
  std::deque<Write> writes_;      // whose data is not complete
  std::deque<AxiData> beats_;     // that came before their address
  std::deque<Response> responses_;
  bool r_due_ = false;            // a read beat, a response, could be given in this cycle
  bool b_due_ = false;
};

}  // namespace castray::sim
