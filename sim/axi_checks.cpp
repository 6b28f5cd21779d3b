// SPDX-License-Identifier: Apache-2.0
#include "axi_checks.hpp"

#include <cinttypes>
#include <cstdio>

namespace castray::sim {
namespace {

constexpr std::size_t kMessages = 20;

std::string text(const char* channel, const AxiAddress& a) {
  char line[120];
  std::snprintf(line, sizeof line, "%s 0x%010" PRIx64 " id %u, %u beats of %u bytes: ", channel, a.address, a.id,
                a.beats(), 1u << a.size);
  return line;
}

}  // namespace

void AxiChecks::report(std::uint64_t now, const std::string& what) {
  ++count_;
  if (messages_.size() < kMessages) messages_.push_back("cycle " + std::to_string(now) + ": " + what);
}

bool AxiChecks::allows(std::uint64_t address, std::uint64_t bytes, bool write) const {
  for (const Window& window : windows_) {
    if (!(write ? window.writable : window.readable)) continue;
    const std::uint64_t offset = address - window.address;
    if (offset <= window.bytes && bytes <= window.bytes - offset) return true;
  }
  return false;
}

void AxiChecks::cycle(const AxiManager& m, const AxiSubordinate& s, std::uint64_t now) {
  if (ar_waits_ && !m.ar_valid) report(now, "ar: valid fell before ready");
  if (aw_waits_ && !m.aw_valid) report(now, "aw: valid fell before ready");
  if (w_waits_ && !m.w_valid) report(now, "w: valid fell before ready");
  if (ar_waits_ && m.ar_valid && !(m.ar == ar_)) report(now, "ar: an untaken address changed");
  if (aw_waits_ && m.aw_valid && !(m.aw == aw_)) report(now, "aw: an untaken address changed");
  if (w_waits_ && m.w_valid && !(m.w == w_)) report(now, "w: an untaken beat changed");
  ar_waits_ = m.ar_valid && !s.ar_ready;
  aw_waits_ = m.aw_valid && !s.aw_ready;
  w_waits_ = m.w_valid && !s.w_ready;
  if (ar_waits_) ar_ = m.ar;
  if (aw_waits_) aw_ = m.aw;
  if (w_waits_) w_ = m.w;
}

void AxiChecks::reset(const AxiManager& m, std::uint64_t now) {
  ar_waits_ = aw_waits_ = w_waits_ = false;
  if (m.ar_valid) report(now, "ar: valid in reset");
  if (m.aw_valid) report(now, "aw: valid in reset");
  if (m.w_valid) report(now, "w: valid in reset");
}

void AxiChecks::burst(const char* channel, const AxiAddress& a, std::uint64_t now) {
  const auto check = [&](bool good, const char* what) {
    if (!good) report(now, text(channel, a) + what);
  };
  check(a.burst == 1, "not an INCR burst");
  check(a.size == 4, "a beat is not 16 bytes");
  check(a.beats() <= 16, "more than 16 beats");
  check(a.address % kBeatBytes == 0, "not aligned to a beat");
  check(a.address / 4096 == (a.address + a.bytes() - 1) / 4096, "crosses 4 KiB");
  check(a.cache == 0b0011, "AxCACHE is not 0011");
  if (channel[1] == 'r') check(allows(a.address, a.bytes(), false), "reads outside the windows of the job");
}

void AxiChecks::beat(const AxiAddress& a, unsigned beat, const AxiData& data, std::uint64_t now) {
  if (data.last != (beat == a.length)) report(now, text("w", a) + (data.last ? "WLAST too early" : "no WLAST"));
  const std::uint64_t first = a.address / kBeatBytes * kBeatBytes + std::uint64_t{beat} * kBeatBytes;
  for (unsigned i = 0; i < kBeatBytes; ++i) {
    if (!(data.strobes >> i & 1)) continue;
    if (first + i < a.address) return report(now, text("w", a) + "a strobe before the burst's first byte");
    if (!allows(first + i, 1, true)) return report(now, text("w", a) + "writes outside the windows of the job");
  }
}

}  // namespace castray::sim
