// SPDX-License-Identifier: Apache-2.0
// Three products and a half: exact at every extreme, every operand in its own product, stages that keep what they hold.
// Verilator: -GRound=32768
#include <array>

#include "Vdot3.h"
#include "chain_run.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

constexpr int kA = 27, kB = 18;
constexpr std::int64_t kRound = 32768;

struct Operands {
  std::array<std::int64_t, 3> a{}, b{};
};

class Dot3 : public testing::TestWithParam<Stalls> {
 protected:
  // Five stages. The last of the sums.
  std::int64_t run(const std::vector<Operands>& items, Stalls stalls = {}) {
    std::int64_t got = 0;
    run_chain(
        dut_, 5, items.size(), stalls,
        [&](std::size_t i) {
          const Operands& o = items[i];
          set_signed(dut_->a0_i, o.a[0], kA), set_signed(dut_->b0_i, o.b[0], kB);
          set_signed(dut_->a1_i, o.a[1], kA), set_signed(dut_->b1_i, o.b[1], kB);
          set_signed(dut_->a2_i, o.a[2], kA), set_signed(dut_->b2_i, o.b[2], kB);
        },
        [&](unsigned load) { dut_->load_i = load; },
        [&](std::size_t i) {
          const Operands& o = items[i];
          got = get_signed(dut_->p_o, kA + kB + 2);
          ASSERT_EQ(got, o.a[0] * o.b[0] + o.a[1] * o.b[1] + o.a[2] * o.b[2] + kRound) << "item " << i;
        });
    return got;
  }

 private:
  Dut<Vdot3> dut_;
};

TEST_F(Dot3, AddsTheHalfOnce) { EXPECT_EQ(run({Operands{}}), kRound); }

TEST_F(Dot3, PairsEveryOperandWithItsOwn) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Operands o;
      o.a[i] = -1000, o.b[j] = 77;
      EXPECT_EQ(run({o}), kRound - (i == j ? 77000 : 0)) << i << j;
    }
}

TEST_F(Dot3, IsExactAtEveryExtreme) {
  const std::int64_t a[4] = {-(1 << (kA - 1)), (1 << (kA - 1)) - 1, -1, 0}, b[3] = {-(1 << (kB - 1)), (1 << (kB - 1)) - 1, 1};
  std::vector<Operands> items;
  for (int i = 0; i < 12 * 12 * 12; ++i) {
    const int k[3] = {i % 12, i / 12 % 12, i / 144};
    Operands o;
    for (int j = 0; j < 3; ++j) o.a[j] = a[k[j] % 4], o.b[j] = b[k[j] / 4];
    items.push_back(o);
  }
  run(items);
}

TEST_P(Dot3, MatchesTheSum) {
  std::mt19937_64 rng(1);
  std::vector<Operands> items(20000);
  for (Operands& o : items)
    for (int j = 0; j < 3; ++j) {
      o.a[j] = wrap_signed(static_cast<std::int64_t>(rng()), kA);
      o.b[j] = wrap_signed(static_cast<std::int64_t>(rng()), kB);
    }
  run(items, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Stalls, Dot3, testing::ValuesIn(kStallPatterns), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace castray::tb
