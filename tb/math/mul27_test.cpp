// SPDX-License-Identifier: Apache-2.0
// The 27 x 27 multiplier: exact at every extreme, one product a cycle, stages that keep what they hold.
#include "Vmul27.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kLow = -(1 << 26), kHigh = (1 << 26) - 1;
using Pair = std::pair<std::int64_t, std::int64_t>;

// Sends the pairs, each entering when its gate is open, and expects their products three cycles on.
void run(const std::vector<Pair>& pairs, double blocked) {
  Dut<Vmul27> dut;
  Gate gate(blocked, 1, 7);
  std::deque<std::int64_t> want;  // one for each of the three stages that is full
  unsigned full = 0;              // bit k: stage k + 1 holds a product
  std::size_t sent = 0, checked = 0;
  std::int64_t last = 0;
  while (checked < pairs.size()) {
    const bool enter = sent < pairs.size() && gate.open();
    const Pair p = sent < pairs.size() ? pairs[sent] : Pair{};
    dut->a_i = static_cast<std::uint32_t>(enter ? p.first : ~p.first) & 0x7ffffff;  // not enabled: anything
    dut->b_i = static_cast<std::uint32_t>(enter ? p.second : ~p.second) & 0x7ffffff;
    dut->en_i = (full << 1 | enter) & 7;
    if (enter) want.push_back(p.first * p.second), ++sent;
    full = dut->en_i;
    dut.tick();
    if (full >> 2 & 1) {
      last = want.front();
      want.pop_front();
      ++checked;
    }
    if (checked) ASSERT_EQ(wrap_signed(static_cast<std::int64_t>(dut->p_o), 54), last) << "product " << checked;
  }
}

}  // namespace

TEST(Mul27, IsExactAtEveryExtreme) {
  std::vector<std::int64_t> ends{0, 1, -1, kLow, kLow + 1, kHigh, kHigh - 1};
  for (int k = 1; k < 26; ++k)
    for (std::int64_t d : {-1, 0, 1}) ends.insert(ends.end(), {(std::int64_t{1} << k) + d, -(std::int64_t{1} << k) + d});
  std::vector<Pair> pairs;
  for (std::int64_t a : ends)
    for (std::int64_t b : ends) pairs.emplace_back(a, b);
  run(pairs, 0);
}

TEST(Mul27, MatchesTheProduct) {
  std::mt19937_64 rng(1);
  std::vector<Pair> pairs;
  for (int i = 0; i < 50000; ++i) pairs.emplace_back(wrap_signed(static_cast<std::int64_t>(rng()), 27), wrap_signed(static_cast<std::int64_t>(rng()), 27));
  run(pairs, 0);
  run(pairs, 0.5);
}

}  // namespace castray::tb
