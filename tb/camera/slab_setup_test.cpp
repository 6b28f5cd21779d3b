// SPDX-License-Identifier: Apache-2.0
// slab_setup: equal to its model under stalls; the model's reciprocals enclose 1 / |S|; powers of two,
// zero and the ends of the format by hand; the rest of a ray passes through.
#include "Vslab_setup.h"
#include "camera/slab_setup.hpp"
#include "blocked.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << ShearFrac;  // S = 1, never reached
constexpr std::int64_t kMantOne = std::int64_t{1} << (RecipW - 1);
constexpr int kStages = 8;

struct Rng : std::mt19937_64 {
  using std::mt19937_64::mt19937_64;
  shear_t shear() {
    const auto k = static_cast<std::int64_t>((*this)() % kOne) >> ((*this)() % (ShearFrac + 2));
    return (*this)() % 2 ? k : -k;
  }
  ray_t ray() {
    packed_t<ray_t> bits;
    for (auto& word : bits) word = static_cast<std::uint32_t>((*this)());
    ray_t r = unpack<ray_t>(bits.data());
    r.sx = shear(), r.sy = shear();
    return r;
  }
};

class SlabSetup : public ::testing::TestWithParam<Stalls> {
 protected:
  std::vector<ray_t> run(const std::vector<ray_t>& in, Stalls stalls = {}) {
    const auto got = run_stream<ray_t>(dut, in, in.size(), stalls);
    EXPECT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_TRUE(got[i] == slab_setup(in[i])) << "in " << to_text(in[i]) << "\n rtl   " << to_text(got[i]) << "\n model " << to_text(slab_setup(in[i]));
    return got;
  }
  // Of S = s in x and -s in y: the same but for the sign.
  recip_t recip(shear_t s) {
    ray_t ray;
    ray.sx = s, ray.sy = -s;
    const ray_t got = run({ray}).at(0);
    recip_t twin = got.rx;
    twin.minus = s > 0;
    EXPECT_TRUE(got.ry == twin) << to_text(got);
    EXPECT_EQ(got.rx.minus, s < 0);
    EXPECT_EQ(got.rx.zero, s == 0);
    return got.rx;
  }
  void expect(shear_t s, int exp, std::int64_t mant) {
    const recip_t r = recip(s);
    EXPECT_EQ(r.exp, static_cast<std::uint64_t>(exp)) << "of " << s;
    EXPECT_EQ(r.mant, static_cast<std::uint64_t>(mant)) << "of " << s;
  }
  Dut<Vslab_setup> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, SlabSetup, ::testing::ValuesIn(kStallPatterns));

TEST_P(SlabSetup, MatchesModel) {
  Rng rng(3);
  std::vector<ray_t> in(20000);
  for (ray_t& ray : in) ray = rng.ray();
  run(in, GetParam());
}

// mant 2^(exp-16) <= 2^ShearFrac / k <= (mant + 1) 2^(exp-16), in integers.
TEST_F(SlabSetup, ModelEnclosesTheReciprocal) {
  Rng rng(4);
  const auto check = [](std::int64_t k) {
    const recip_t r = recip_of(k);
    ASSERT_GE(r.mant, static_cast<std::uint64_t>(kMantOne));
    ASSERT_LT(r.mant, static_cast<std::uint64_t>(2 * kMantOne));
    const int128 exact = int128{1} << (ShearFrac + RecipW - 1), unit = int128{k} << r.exp;
    ASSERT_LE(static_cast<int128>(r.mant) * unit, exact) << k;
    ASSERT_LE(exact, static_cast<int128>(r.mant + 1) * unit) << k;
  };
  for (int i = 0; i < 2000000; ++i)
    if (const shear_t s = rng.shear(); s != 0) check(std::abs(s));
  for (int bit = 0; bit < static_cast<int>(ShearFrac); ++bit)
    for (std::int64_t k = std::max<std::int64_t>((std::int64_t{1} << bit) - 2, 1); k < std::min(kOne, (std::int64_t{1} << bit) + 3); ++k) check(k);
}

TEST_F(SlabSetup, KnowsPowersOfTwo) {
  for (int bit = 0; bit < static_cast<int>(ShearFrac); ++bit)
    expect(std::int64_t{1} << bit, static_cast<int>(ShearFrac) - 1 - bit, 2 * kMantOne - 1);
}

TEST_F(SlabSetup, KnowsTheEndsOfTheFormat) {
  expect(kOne - 1, 0, kMantOne);
  expect(1 - kOne, 0, kMantOne);
  expect(kOne / 2 + 1, 0, 2 * kMantOne - 1);
  expect(kOne / 2 - 1, 1, kMantOne);
  expect(3 * (kOne / 4), 0, 4 * kMantOne / 3);
}

TEST_F(SlabSetup, GivesZeroTheLargest) { expect(0, 31, kMantOne); }

TEST_F(SlabSetup, FillsEveryStageWhileBlocked) {
  Rng rng(5);
  std::vector<ray_t> rays(kStages + 1);
  for (ray_t& ray : rays) ray = rng.ray();
  fill_and_drain<ray_t>(dut, kStages, [&](int i) { return rays[i]; }, [&](int i) { return slab_setup(rays[i]); });
}

TEST_F(SlabSetup, GivesOneRayACycle) {
  const long start = dut.cycles();
  run(std::vector<ray_t>(1000, Rng(6).ray()));
  EXPECT_EQ(dut.cycles() - start, 1000 + kStages);
}

}  // namespace
}  // namespace castray::tb
