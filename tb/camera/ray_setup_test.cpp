// SPDX-License-Identifier: Apache-2.0
// ray_setup: equal to its model under stalls; axes, ties, clamp, the zero direction and the
// extremes of Q3.42 by hand.
#include "Vray_setup.h"
#include "camera/ray_setup.hpp"
#include "blocked.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << ShearFrac;  // S = 1, never reached
constexpr std::int64_t kCompMax = (std::int64_t{1} << (dir_comp_t_bits - 1)) - 1;
constexpr std::int64_t kCompMin = -kCompMax - 1;
constexpr int kStages = 4 + 12 + 5;

// What a camera asks for.
ray_req_t item(std::int64_t x, std::int64_t y, std::int64_t z) {
  camera_t camera;
  camera.eye = {.z = 3, .y = (1u << CoordW) - 1, .x = 0};
  return camera_request({.z = z, .y = y, .x = x}, camera, {.x = 1, .y = 2, .slot = 3});
}

class RaySetup : public ::testing::TestWithParam<Stalls> {
 protected:
  static ray_t model(const ray_req_t& in) { return ray_setup(in); }
  std::vector<ray_t> run(const std::vector<ray_req_t>& in, Stalls stalls = {}) {
    const auto got = run_stream<ray_t>(dut, in, in.size(), stalls);
    EXPECT_EQ(got.size(), in.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_TRUE(got[i] == model(in[i])) << "in " << to_text(in[i]) << "\n rtl   " << to_text(got[i]) << "\n model " << to_text(model(in[i]));
    return got;
  }
  ray_t run_one(std::int64_t x, std::int64_t y, std::int64_t z) { return run({item(x, y, z)}).at(0); }

  Dut<Vray_setup> dut;
};
INSTANTIATE_TEST_SUITE_P(Stalls, RaySetup, ::testing::ValuesIn(kStallPatterns));

TEST_P(RaySetup, MatchesModel) {
  std::mt19937_64 rng(11);
  std::vector<ray_req_t> in(20000);
  for (auto& pixel : in) {
    // Components of any magnitude; now and then equal ones.
    const auto component = [&] { return wrap_signed(static_cast<std::int64_t>(rng()), dir_comp_t_bits) >> (rng() % (rng() % 4 ? 6 : 46)); };
    pixel = item(component(), component(), component());
    if (rng() % 8 == 0) pixel.dir.y = rng() % 2 ? pixel.dir.x : -pixel.dir.x;
    if (rng() % 8 == 0) pixel.dir.z = rng() % 2 ? pixel.dir.y : -pixel.dir.y;
    pixel.dir = {.z = wrap_signed(pixel.dir.z, dir_comp_t_bits), .y = wrap_signed(pixel.dir.y, dir_comp_t_bits), .x = pixel.dir.x};
    pixel.tag = {.x = rng() % 4096, .y = rng() % 4096, .slot = rng() % 256};
    const auto coord = [&] { return rng() & ((1u << CoordW) - 1); };
    pixel.org = {.z = coord(), .y = coord(), .x = coord()};
    pixel.tmin = wrap_signed(static_cast<std::int64_t>(rng()), t_t_bits), pixel.tmax = wrap_signed(static_cast<std::int64_t>(rng()), t_t_bits);
    pixel.cull = rng() & 1, pixel.any_hit = rng() & 1, pixel.ok = rng() % 8 != 0, pixel.ignore = rng() & static_cast<std::uint64_t>(NoPrim);
  }
  run(in, GetParam());
}

TEST_F(RaySetup, KnowsEverySignedAxis) {
  // Components 8, 2, -4 in cyclic order from the dominant one: S = (2, -4) / 8, halves of one.
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {1, -1}) {
      std::int64_t dir[3];
      dir[axis] = 8 * sign;
      dir[(axis + 1) % 3] = 2;
      dir[(axis + 2) % 3] = -4;
      const ray_t ray = run_one(dir[0], dir[1], dir[2]);
      EXPECT_EQ(ray.axis, static_cast<axis_t>(axis));
      EXPECT_EQ(ray.neg, sign < 0);
      EXPECT_EQ(ray.sx, sign * kOne / 4);
      EXPECT_EQ(ray.sy, -sign * kOne / 2);
      EXPECT_EQ(ray.norm2, (16u + 1 + 4) << (NormFrac - 4));
      EXPECT_EQ(ray.valid, 1u);
    }
}

TEST_F(RaySetup, GivesTheLowestAxisToEqualComponents) {
  for (const std::int64_t k : {std::int64_t{1}, std::int64_t{12345}, std::int64_t{1} << 31, kCompMax})
    for (int signs = 0; signs < 8; ++signs) {
      const std::int64_t x = signs & 1 ? -k : k, y = signs & 2 ? -k : k, z = signs & 4 ? -k : k;
      EXPECT_EQ(run_one(x, y, z).axis, 0u);
      EXPECT_EQ(run_one(x, y, 0).axis, 0u);
      EXPECT_EQ(run_one(x, 0, z).axis, 0u);
      EXPECT_EQ(run_one(0, y, z).axis, 1u);
      EXPECT_EQ(run_one(x / 2, y, z).axis, 1u);
    }
  // One more in magnitude wins, the most negative number included.
  EXPECT_EQ(run_one(kCompMax, kCompMin, kCompMax).axis, 1u);
  EXPECT_EQ(run_one(kCompMax, kCompMax, kCompMin).axis, 2u);
  EXPECT_EQ(run_one(-kCompMax, kCompMax - 1, kCompMin).axis, 2u);
  EXPECT_EQ(run_one(-7, 8, -8).axis, 1u);
}

TEST_F(RaySetup, ClampsTheShearBelowOne) {
  for (const std::int64_t k : {std::int64_t{1}, std::int64_t{3}, std::int64_t{1} << 40, kCompMax}) {
    const ray_t ray = run_one(k, k, -k);
    EXPECT_EQ(ray.sx, kOne - 1);
    EXPECT_EQ(ray.sy, 1 - kOne);
    EXPECT_EQ(ray.norm2, (3u << NormFrac) - 1);
  }
  // Rounds to one: 1 - 2^-27, a half. Just below the half it rounds to 1 - 2^-26 by itself.
  const std::int64_t den = std::int64_t{1} << 30;
  EXPECT_EQ(run_one(den - 8, 0, den).sx, kOne - 1);
  EXPECT_EQ(run_one(den - 9, 0, den).sx, kOne - 1);
  EXPECT_EQ(run_one(den - 16, 0, den).sx, kOne - 1);
  EXPECT_EQ(run_one(den - 25, 0, den).sx, kOne - 2);
}

TEST_F(RaySetup, RoundsHalfQuotientsAwayFromZero) {
  const std::int64_t den = std::int64_t{1} << 27;  // quotients are halves of 2^-26
  for (const auto& [num, s] : {std::array<std::int64_t, 2>{1, 1}, {3, 2}, {5, 3}, {2, 1}, {4, 2}}) {
    const ray_t ray = run_one(num, -num, den);
    EXPECT_EQ(ray.sx, s);
    EXPECT_EQ(ray.sy, -s);
    EXPECT_EQ(run_one(num, -num, -den).sx, -s);
  }
  EXPECT_EQ(run_one(1, 0, den + 1).sx, 0) << "below the half";
}

TEST_F(RaySetup, RoundsHalvesOfTheNormUp) {
  // sx^2 + sy^2 = 2^27 in units of 2^-52: half a last bit of Q2.24.
  const std::int64_t s = 1 << 13;
  EXPECT_EQ(run_one(s, s, kOne).norm2, (1u << NormFrac) + 1);
  EXPECT_EQ(run_one(s, s - 1, kOne).norm2, 1u << NormFrac);
  EXPECT_EQ(run_one(s, -s, -kOne).norm2, (1u << NormFrac) + 1);
}

TEST_F(RaySetup, DropsWhatLiesBelow32Bits) {
  const std::int64_t den = (std::int64_t{1} << 43) + 4095, num = (std::int64_t{1} << 39) + 4095;  // 12 bits too many
  EXPECT_EQ(run_one(num, 1, den).sx, run_one(num - 4095, 4095, den - 4095).sx);
  EXPECT_EQ(run_one(num, 4095, den).sy, 0);
  // 2^44, the largest magnitude: 13 bits too many.
  EXPECT_EQ(run_one(kCompMin, std::int64_t{1} << 43, 8191).sx, -kOne / 2);
  EXPECT_EQ(run_one(kCompMin, std::int64_t{1} << 43, 8191).sy, 0);
}

TEST_F(RaySetup, KeepsTheExtremesOfItsFormat) {
  const std::vector<std::int64_t> values = {kCompMin, kCompMin + 1, -kCompMax / 2, -1, 0, 1, kCompMax / 2, kCompMax - 1, kCompMax};
  std::vector<ray_req_t> in;
  for (const auto x : values)
    for (const auto y : values)
      for (const auto z : values) in.push_back(item(x, y, z));
  for (int bit = 0; bit < dir_comp_t_bits - 1; ++bit) {
    const std::int64_t k = std::int64_t{1} << bit;
    for (const auto& pixel : {item(k, k - 1, 1), item(1 - k, -k, k), item(k, k + 1, -k - 1), item(0, 0, -k)}) in.push_back(pixel);
  }
  run(in);
}

TEST_F(RaySetup, MarksTheZeroDirection) {
  const ray_t ray = run_one(0, 0, 0);
  EXPECT_EQ(ray.valid, 0u);
  EXPECT_EQ(ray.sx, 0);
  EXPECT_EQ(ray.sy, 0);
  EXPECT_EQ(ray.norm2, 1u << NormFrac);
  EXPECT_EQ(ray.axis, 0u);
  EXPECT_EQ(ray.neg, 0u);
  EXPECT_EQ(run_one(0, -1, 0).valid, 1u);
}

TEST_F(RaySetup, FillsInTheRestOfTheRay) {
  const ray_t ray = run_one(5, -6, 7);
  EXPECT_TRUE(ray.org == permuted(item(0, 0, 0).org, ray.axis));
  EXPECT_TRUE(ray.tag == item(0, 0, 0).tag);
  EXPECT_EQ(ray.tmin, 0);
  EXPECT_EQ(ray.tmax, TMax);
  EXPECT_EQ(ray.ignore, static_cast<prim_t>(NoPrim));
  EXPECT_EQ(ray.cull | ray.any_hit, 0u);
}

TEST_F(RaySetup, TakesLimitsFlagsAndOrigin) {
  ray_req_t req = item(-7, 5, 6);
  req.org = {.z = 1, .y = 2, .x = 3};
  req.tmin = -4, req.tmax = 5, req.cull = 1, req.ignore = 6;
  const ray_t ray = run({req}).at(0);
  EXPECT_TRUE(ray.org == (point_t{.z = 3, .y = 1, .x = 2}));   // on permuted axes: x is the dominant one
  EXPECT_EQ(ray.tmin, -4);
  EXPECT_EQ(ray.tmax, 5);
  EXPECT_EQ(ray.ignore, 6u);
  EXPECT_EQ(ray.cull, 1u);
  EXPECT_EQ(ray.any_hit, 0u);
  EXPECT_EQ(ray.valid, 1u);
}

TEST_F(RaySetup, MarksARequestThatIsNotOk) {
  ray_req_t req = item(5, -6, 7);
  req.ok = 0, req.any_hit = 1;
  const ray_t ray = run({req}).at(0);
  EXPECT_EQ(ray.valid, 0u);
  EXPECT_EQ(ray.any_hit, 1u);
}

TEST_F(RaySetup, FillsEveryStageWhileBlocked) {
  const auto pixel = [&](int i) { return item(i + 1, -5, 1000); };
  fill_and_drain<ray_t>(dut, kStages, pixel, [&](int i) { return model(pixel(i)); });
}

TEST_F(RaySetup, GivesOneRayACycle) {
  const long start = dut.cycles();
  run(std::vector<ray_req_t>(1000, item(3, 2, 1)));
  EXPECT_EQ(dut.cycles() - start, 1000 + kStages);
}

}  // namespace
}  // namespace castray::tb
