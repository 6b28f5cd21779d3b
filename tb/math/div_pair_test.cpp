// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Two divisions by products: equal to the division at ties and at every kind of end, for the widths of the core and
// for narrow and wide ones; one pair a cycle, stages that keep what they hold.
#include "Vdiv_pair.h"
#include "dut.hpp"
#include "math/div_pipe.hpp"

namespace castray::tb {
namespace {

// As in div_pair_tb.sv.
struct Config {
  int den_w, qfrac;
  std::uint64_t least() const { return std::uint64_t{1} << (den_w - 1); }
  std::uint64_t most() const { return 2 * least() - 1; }
};
constexpr Config kConfigs[] = {{26, 24}, {32, 26}, {19, 15}, {45, 16}};
constexpr int kStages = 12;

struct Pair {
  std::uint64_t num0 = 0, num1 = 0, den = 0;
};

class DivPair : public ::testing::TestWithParam<int> {
 protected:
  // Sends the pairs, each entering when its gate is open, and expects their quotients twelve cycles on.
  void run(const std::vector<Pair>& pairs, double blocked = 0) {
    Dut<Vdiv_pair> dut;
    dut->which_i = GetParam();
    Gate gate(blocked, 1, 7);
    unsigned full = 0;   // bit k: stage k + 1 holds one
    std::size_t sent = 0, checked = 0;
    while (checked < pairs.size()) {
      const bool enter = sent < pairs.size() && gate.open();
      const Pair in = enter ? pairs[sent] : Pair{sent * 40503, sent * 39916801, config.least() | sent};
      dut->num0_i = in.num0, dut->num1_i = in.num1, dut->den_i = in.den;
      full = (full << 1 | enter) & ((1u << kStages) - 1);
      dut->en_i = full;
      sent += enter;
      dut.tick();
      if (!(full >> (kStages - 1))) continue;
      const Pair& p = pairs[checked++];
      ASSERT_EQ(dut->q0_o, expected(p.num0, p.den)) << p.num0 << " / " << p.den;
      ASSERT_EQ(dut->q1_o, expected(p.num1, p.den)) << p.num1 << " / " << p.den;
    }
  }
  std::uint64_t expected(std::uint64_t num, std::uint64_t den) const {
    return den < config.least() ? 0 : div_nearest(num, den, config.qfrac);
  }
  std::uint64_t divisor() { return config.least() | (rng() & config.most()); }
  // The least num whose quotient is at least q - 1/2, if there is one: on it, or just above it, q begins.
  std::uint64_t begin_of(std::uint64_t q, std::uint64_t den) const {
    const uint128 twice = static_cast<uint128>(2 * q - 1) * den;
    return static_cast<std::uint64_t>((twice + (uint128{1} << (config.qfrac + 1)) - 1) >> (config.qfrac + 1));
  }

  Config config = kConfigs[GetParam()];
  std::mt19937_64 rng{11};
};
INSTANTIATE_TEST_SUITE_P(Widths, DivPair, ::testing::Range(0, static_cast<int>(std::size(kConfigs))));

TEST_P(DivPair, MatchesModel) {
  std::vector<Pair> in(300000);
  for (Pair& p : in) p.den = divisor(), p.num0 = rng() % (p.den + 1), p.num1 = (rng() % (p.den + 1)) >> (rng() % config.den_w);
  run(in);
  in.resize(30000);
  run(in, 0.5);
}

// Where a quotient begins, and one below: what an estimate alone gets wrong.
TEST_P(DivPair, IsExactWhereAQuotientBegins) {
  std::vector<Pair> in;
  for (int i = 0; i < 300000; ++i) {
    const std::uint64_t den = i % 8 ? divisor() : i % 16 ? config.least() + i / 16 : config.most() - i / 16;
    const std::uint64_t first = begin_of(1 + rng() % ((std::uint64_t{1} << config.qfrac) >> (i % config.qfrac)), den);
    in.push_back({first, first - (first != 0), den});
  }
  run(in);
}

// An odd multiple of den / 2^(qfrac + 1), where there is one, is a tie.
TEST_P(DivPair, TakesTiesUp) {
  std::vector<Pair> in;
  for (std::uint64_t k = 1; k < 4000; k += 2) {
    const std::uint64_t unit = config.least() >> std::min(config.den_w - 1, config.qfrac + 1);
    in.push_back({unit * k % config.least(), config.least() - unit * k % config.least(), config.least()});
  }
  run(in);
}

TEST_P(DivPair, KnowsTheEnds) {
  std::vector<Pair> in;
  for (const std::uint64_t den : {config.least(), config.least() + 1, config.least() + 2, config.most() - 1, config.most(), config.least() * 3 / 2})
    for (const std::uint64_t d : {0, 1, 2, 3}) in.insert(in.end(), {{den - d, d, den}, {d, den - d, den}, {den / 2 + d, den / 2 - d, den}});
  run(in);
}

TEST_P(DivPair, GivesZeroForADivisorWithoutItsTopBit) { run({{0, 0, 0}, {1, 1, 1}, {5, config.least() - 1, config.least() - 1}, {0, 0, 0}}); }

}  // namespace
}  // namespace castray::tb
