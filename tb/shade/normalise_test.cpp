// SPDX-License-Identifier: Apache-2.0
// Runs long.
// normalise: equal to its model under stalls; accurate against double; extremes by hand.
#include <cmath>

#include "Vnormalise.h"
#include "blocked.hpp"
#include "shade/normalise.hpp"

namespace castray::tb {
namespace {

constexpr int kStages = 5 + 13 + 11 + 3;
constexpr double kBound = 3;  // units of 2^-16
constexpr std::int64_t kMax = (1 << 28) - 1, kMin = -(1 << 28);

struct Vector {
  static constexpr int kBits = 97;
  std::int64_t x = 0, y = 0, z = 0;
  std::uint64_t tag = 0;
  template <class F> void each_field(F&& f) const {
    f("z", z, 0, 29, true);
    f("y", y, 29, 29, true);
    f("x", x, 58, 29, true);
    f("tag", tag, 87, 10, false);
  }
};
struct Unit {
  static constexpr int kBits = 64;
  std::int64_t x = 0, y = 0, z = 0;
  std::uint64_t tag = 0;
  template <class F> void each_field(F&& f) {
    f("z", z, 0, 18, true);
    f("y", y, 18, 18, true);
    f("x", x, 36, 18, true);
    f("tag", tag, 54, 10, false);
  }
  bool operator==(const Unit&) const = default;
};
std::ostream& operator<<(std::ostream& os, const Unit& u) { return os << u.x << " " << u.y << " " << u.z << " tag " << u.tag; }

Unit model(const Vector& v) {
  const unit3_t unit = normalise(v.x, v.y, v.z);
  return {unit.x, unit.y, unit.z, v.tag};
}

// Components of any magnitude, together and apart.
Vector random_vector(std::mt19937_64& rng) {
  const int all = rng() % 4 ? 0 : rng() % 29;
  const auto component = [&] { return wrap_signed(static_cast<std::int64_t>(rng()), 29) >> (all + (rng() % 4 ? 0 : rng() % 29)); };
  return {component(), component(), component()};
}

class Normalise : public ::testing::TestWithParam<Stalls> {
 protected:
  std::vector<Unit> run(std::vector<Vector> in, Stalls stalls = {}) {
    for (std::size_t i = 0; i < in.size(); ++i) in[i].tag = i * 381 & 0x3ff;
    const auto got = run_stream<Unit>(dut, in, in.size(), stalls);
    EXPECT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], model(in[i])) << in[i].x << " " << in[i].y << " " << in[i].z;
    return got;
  }
  Unit run_one(std::int64_t x, std::int64_t y, std::int64_t z) { return run({{x, y, z}}).at(0); }
  Dut<Vnormalise> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, Normalise, ::testing::ValuesIn(kStallPatterns));

TEST_P(Normalise, MatchesModel) {
  std::mt19937_64 rng(3);
  std::vector<Vector> in(20000);
  for (auto& v : in) v = random_vector(rng);
  run(in, GetParam());
}

TEST_F(Normalise, ModelIsAccurate) {
  std::mt19937_64 rng(4);
  double worst = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const Vector v = random_vector(rng);
    const double length = std::sqrt(double(v.x) * double(v.x) + double(v.y) * double(v.y) + double(v.z) * double(v.z));
    if (length == 0) continue;
    const Unit unit = model(v);
    worst = std::max({worst, std::abs(unit.x - 65536 * v.x / length), std::abs(unit.y - 65536 * v.y / length),
                      std::abs(unit.z - 65536 * v.z / length)});
  }
  EXPECT_LE(worst, kBound);
  EXPECT_GE(worst, 1) << "the vectors do not reach the bound's neighbourhood";
}

TEST_F(Normalise, GivesZeroForZero) { EXPECT_EQ(run_one(0, 0, 0), Unit()); }

TEST_F(Normalise, IsExactOnTheAxes) {
  for (const std::int64_t k : {std::int64_t{1}, std::int64_t{2}, std::int64_t{3}, std::int64_t{65535}, std::int64_t{65536}, std::int64_t{65537}, std::int64_t{1} << 27, kMax})
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {1, -1}) {
        std::int64_t v[3] = {};
        v[axis] = sign * k;
        const Unit unit = run_one(v[0], v[1], v[2]);
        const std::int64_t got[3] = {unit.x, unit.y, unit.z};
        for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(got[i] - (i == axis ? sign * 65536 : 0)), k & (k - 1) ? 1 : 0) << "axis " << axis << " length " << sign * k;
      }
}

TEST_F(Normalise, TakesTheLargestNegative) {
  EXPECT_EQ(run_one(kMin, 0, 0), (Unit{-65536, 0, 0}));
  EXPECT_EQ(run_one(0, 0, kMin), (Unit{0, 0, -65536}));
  const Unit all = run_one(kMin, kMin, kMin);
  EXPECT_NEAR(all.x, -37837.2, kBound);
  EXPECT_EQ(all.x, all.y);
  EXPECT_EQ(all.x, all.z);
  run({{kMin, kMax, kMin}, {kMax, kMax, kMax}, {kMin, 1, -1}, {-1, kMin, kMax}, {kMin + 1, kMin + 1, kMin + 1}});
}

// The squared length where the root's radicand changes its scale, 2^34, and its neighbours.
TEST_F(Normalise, ChangesScaleAtTheRightLength) {
  std::vector<Vector> in;
  for (int dx = -2; dx <= 2; ++dx)
    for (int dy = -2; dy <= 2; ++dy) {
      in.push_back({92682 + dx, 92682 + dy, 0});       // (2^17 / sqrt 2)^2 twice
      in.push_back({75674 + dx, 75674 + dy, 75674});   // (2^17 / sqrt 3)^2 three times
      in.push_back({131071 + dx, dy, 0});
    }
  run(in);
}

TEST_F(Normalise, RoundsNegativeSharesDown) {
  // -3 among larger ones: the shift to the right is a floor, so -3 / 4 becomes -1, and 3 / 4 zero.
  EXPECT_EQ(run_one(1 << 18, -3, 3), (Unit{65536, -1, 0}));
}

TEST_F(Normalise, FillsEveryStageWhileBlocked) {
  const auto item = [](int i) { return Vector{1000 + i, -3 * i, i * i, static_cast<std::uint64_t>(i)}; };
  fill_and_drain<Unit>(dut, kStages, item, [&](int i) { return model(item(i)); });
}

}  // namespace
}  // namespace castray::tb
