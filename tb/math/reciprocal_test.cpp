// SPDX-License-Identifier: Apache-2.0
// The reciprocal by table and remainder: equal to the division at both ends of every quotient, at every end of the
// table's parts, and anywhere; one a cycle, stages that keep what they hold.
#include "Vreciprocal.h"
#include "dut.hpp"
#include "math/div_pipe.hpp"

namespace castray::tb {
namespace {

constexpr int kDenW = 26;   // the module's default
constexpr std::uint64_t kLeast = std::uint64_t{1} << (kDenW - 1), kMost = 2 * kLeast - 1, kStages = 6;

std::uint64_t expected(std::uint64_t den) {
  return std::min(div_floor(kLeast, den, RecipW), (std::uint64_t{1} << RecipW) - 1);
}

// Sends the numbers, each entering when its gate is open, and expects their reciprocals six cycles on.
void run(const std::vector<std::uint64_t>& dens, double blocked) {
  Dut<Vreciprocal> dut;
  Gate gate(blocked, 1, 7);
  unsigned full = 0;   // bit k: stage k + 1 holds one
  std::size_t sent = 0, checked = 0;
  while (checked < dens.size()) {
    const bool enter = sent < dens.size() && gate.open();
    dut->den_i = static_cast<std::uint32_t>(enter ? dens[sent] : kLeast | (sent * 40503 & kMost));
    full = (full << 1 | enter) & ((1u << kStages) - 1);
    dut->en_i = full;
    sent += enter;
    dut.tick();
    if (full >> (kStages - 1)) {
      ASSERT_EQ(dut->q_o, expected(dens[checked])) << "of " << dens[checked];
      ++checked;
    }
  }
}

TEST(Reciprocal, IsExactAtBothEndsOfEveryQuotient) {
  const std::uint64_t one = std::uint64_t{1} << (kDenW - 1 + RecipW);
  std::vector<std::uint64_t> dens;
  for (std::uint64_t q = std::uint64_t{1} << (RecipW - 1); q <= std::uint64_t{1} << RecipW; ++q)
    for (const std::uint64_t den : {one / q - 1, one / q, one / q + 1})
      if (den >= kLeast && den <= kMost) dens.push_back(den);
  run(dens, 0);
}

TEST(Reciprocal, IsExactAtTheEndsOfTheTablesParts) {
  constexpr std::uint64_t kParts = std::uint64_t{1} << ((RecipW + 1) / 2);
  std::vector<std::uint64_t> dens;
  for (std::uint64_t part = 0; part < kParts; ++part) {
    const std::uint64_t first = kLeast + part * (kLeast / kParts);
    for (std::uint64_t i = 0; i < 40; ++i) dens.insert(dens.end(), {first + i, first + kLeast / kParts - 1 - i, first + kLeast / kParts / 2 + i});
  }
  run(dens, 0);
}

TEST(Reciprocal, MatchesTheDivision) {
  std::mt19937_64 rng(1);
  std::vector<std::uint64_t> dens(200000);
  for (std::uint64_t& den : dens) den = kLeast | (rng() & kMost);
  run(dens, 0);
  run(dens, 0.5);
}

}  // namespace
}  // namespace castray::tb
