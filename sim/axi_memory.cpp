// SPDX-License-Identifier: Apache-2.0
#include "axi_memory.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace castray::sim {
namespace {
constexpr std::size_t kEarlyBeats = 16;  // write data taken before its address
constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
}  // namespace

AxiTiming AxiTiming::named(const std::string& name) {
  AxiTiming timing;
  timing.name = name;
  if (name == "hp") {
    timing.outstanding = 8;
  } else if (name != "reference") {
    throw std::invalid_argument("unknown memory '" + name + "'");
  }
  return timing;
}

AxiCounters& AxiCounters::operator+=(const AxiCounters& other) {
  reads += other.reads;
  read_beats += other.read_beats;
  writes += other.writes;
  write_beats += other.write_beats;
  bytes_written += other.bytes_written;
  errors += other.errors;
  reordered += other.reordered;
  dropped += other.dropped;
  most_reads = std::max(most_reads, other.most_reads);
  most_writes = std::max(most_writes, other.most_writes);
  return *this;
}

AxiMemory::AxiMemory(Storage& storage, AxiTiming timing, Stalls stalls, std::uint64_t seed)
    : storage_(&storage), timing_(std::move(timing)), stalls_(std::move(stalls)), random_(seed) {
  drive_.ar_ready = drive_.aw_ready = drive_.w_ready = true;
}

template <class Queue> std::optional<std::size_t> AxiMemory::pick(const Queue& queue, std::uint64_t now) {
  if (!timing_.reorder) {
    if (queue.empty() || queue.front().due > now) return std::nullopt;
    return 0;
  }
  const auto id_of = [](const auto& item) {
    if constexpr (requires { item.address.id; }) return item.address.id;
    else return item.id;
  };
  std::uint32_t seen = 0;
  std::array<std::size_t, 16> ready{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < queue.size() && count < ready.size(); ++i) {
    const std::uint32_t bit = 1u << (id_of(queue[i]) & 15);
    if (seen & bit) continue;
    seen |= bit;
    if (queue[i].due <= now) ready[count++] = i;
  }
  if (count == 0) return std::nullopt;
  return ready[random_() % count];
}

AxiResponse AxiMemory::response_at(std::uint64_t address) const {
  for (const BusFault& fault : faults_)
    if (address - fault.address < fault.bytes) return fault.response;
  return kOkay;
}

void AxiMemory::take_addresses(const AxiManager& m) {
  if (m.ar_valid) {
    if (open_reads() < timing_.outstanding) stalls_.wanted(kAr, !drive_.ar_ready);
    if (drive_.ar_ready) {
      checks_.burst("ar", m.ar, cycle_);
      reads_.push_back({m.ar, 0, cycle_ + timing_.latency});
      ++counters_.reads;
      counters_.most_reads = std::max(counters_.most_reads, static_cast<unsigned>(open_reads()));
      last_activity_ = cycle_;
    }
  }
  if (m.aw_valid) {
    if (open_writes() < timing_.outstanding) stalls_.wanted(kAw, !drive_.aw_ready);
    if (drive_.aw_ready) {
      checks_.burst("aw", m.aw, cycle_);
      writes_.push_back({m.aw});
      ++counters_.writes;
      counters_.most_writes = std::max(counters_.most_writes, static_cast<unsigned>(open_writes()));
      last_activity_ = cycle_;
    }
  }
}

void AxiMemory::store(Write& write, const AxiData& data) {
  checks_.beat(write.address, write.done, data, cycle_);
  const std::uint64_t first = write.address.address / kBeatBytes * kBeatBytes + std::uint64_t{write.done} * kBeatBytes;
  AxiResponse response = response_at(first);
  for (unsigned i = 0; i < kBeatBytes; ++i) {
    if (!(data.strobes >> i & 1)) continue;
    std::uint8_t* byte = storage_->find(first + i, 1);
    if (!byte) response = kDecErr;
    if (byte && response == kOkay) *byte = static_cast<std::uint8_t>(data.data[i / 4] >> (8 * (i % 4)));
    ++counters_.bytes_written;
  }
  write.response = std::max(write.response, response);
  ++write.done;
}

void AxiMemory::take_data(const AxiManager& m) {
  if (m.w_valid) {
    if (beats_.size() < kEarlyBeats) stalls_.wanted(kW, !drive_.w_ready);
    if (drive_.w_ready) {
      beats_.push_back(m.w);
      ++counters_.write_beats;
      last_activity_ = cycle_;
    }
  }
  while (!beats_.empty() && !writes_.empty()) {
    Write& write = writes_.front();
    store(write, beats_.front());
    beats_.pop_front();
    if (write.done < write.address.beats()) continue;
    counters_.errors += write.response != kOkay;
    responses_.push_back({write.address.id, write.response, cycle_ + timing_.latency});
    writes_.pop_front();
  }
}

void AxiMemory::read_beat(const Read& read) {
  const std::uint64_t first = read.address.address / kBeatBytes * kBeatBytes + std::uint64_t{read.done} * kBeatBytes;
  const std::uint8_t* bytes = storage_->find(first, kBeatBytes);
  drive_.r_response = bytes ? response_at(first) : kDecErr;
  drive_.r_data.fill(0);
  if (drive_.r_response == kOkay) std::memcpy(drive_.r_data.data(), bytes, kBeatBytes);
  counters_.errors += drive_.r_response != kOkay;
  drive_.r_id = read.address.id;
  drive_.r_last = read.done == read.address.length;
  drive_.r_valid = true;
  moved_ = true;
}

// Decides r_valid of the next cycle.
void AxiMemory::drive_reads() {
  const auto next = pick(reads_, cycle_ + 1);
  r_due_ = next.has_value();
  if (!next || !stalls_.open(kR)) return;
  Read& read = reads_[*next];
  read_beat(read);
  counters_.reordered += *next != 0;
  ++counters_.read_beats;
  if (++read.done == read.address.beats()) reads_.erase(reads_.begin() + static_cast<std::ptrdiff_t>(*next));
}

// Decides b_valid of the next cycle.
void AxiMemory::drive_responses() {
  const auto next = pick(responses_, cycle_ + 1);
  b_due_ = next.has_value();
  if (!next || !stalls_.open(kB)) return;
  drive_.b_valid = true;
  drive_.b_id = responses_[*next].id;
  drive_.b_response = responses_[*next].response;
  counters_.reordered += *next != 0;
  responses_.erase(responses_.begin() + static_cast<std::ptrdiff_t>(*next));
  moved_ = true;
}

void AxiMemory::sleep_until_next() {
  wake_ = 0;
  if (stalls_.any() || checks_.watching() || drive_.r_valid || drive_.b_valid) return;
  if (!drive_.ar_ready || !drive_.aw_ready || !drive_.w_ready) return;
  wake_ = kNever;
  // A due time d is driven from the step of cycle d - 1 on.
  for (const Read& read : reads_) wake_ = std::min(wake_, read.due - 1);
  for (const Response& response : responses_) wake_ = std::min(wake_, response.due - 1);
}

void AxiMemory::step(const AxiManager& m) {
  moved_ = false;
  checks_.cycle(m, drive_, cycle_);
  take_addresses(m);
  take_data(m);
  if (m.r_ready && (drive_.r_valid || r_due_)) stalls_.wanted(kR, !drive_.r_valid);
  if (m.b_ready && (drive_.b_valid || b_due_)) stalls_.wanted(kB, !drive_.b_valid);

  const bool r_free = !drive_.r_valid || m.r_ready;
  const bool b_free = !drive_.b_valid || m.b_ready;
  if ((drive_.r_valid && r_free) || (drive_.b_valid && b_free)) moved_ = true;
  stalls_.advance();
  if (r_free) {
    drive_.r_valid = false;
    drive_reads();
  }
  if (b_free) {
    drive_.b_valid = false;
    drive_responses();
  }
  const bool ar = stalls_.open(kAr) && open_reads() < timing_.outstanding;
  const bool aw = stalls_.open(kAw) && open_writes() < timing_.outstanding;
  const bool w = stalls_.open(kW) && beats_.size() < kEarlyBeats;
  moved_ |= ar != drive_.ar_ready || aw != drive_.aw_ready || w != drive_.w_ready;
  drive_.ar_ready = ar;
  drive_.aw_ready = aw;
  drive_.w_ready = w;
  ++cycle_;
  sleep_until_next();
}

void AxiMemory::reset(const AxiManager& m) {
  checks_.reset(m, cycle_);
  counters_.dropped += reads_.size() + writes_.size() + responses_.size();
  reads_.clear();
  writes_.clear();
  beats_.clear();
  responses_.clear();
  drive_ = {};
  drive_.ar_ready = drive_.aw_ready = drive_.w_ready = true;
  r_due_ = b_due_ = false;
  moved_ = true;
  wake_ = 0;
  ++cycle_;
}

}  // namespace castray::sim
