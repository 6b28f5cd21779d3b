// SPDX-License-Identifier: Apache-2.0
// tile_bounds: equal to its model under stalls, on slopes at and beside the steps to which bounds are rounded; the bounds
// lie at least a last bit beyond the corners, as docs/tile-start.md counts on.
#include "Vtile_bounds.h"
#include "dut.hpp"
#include "traverse/tile_bounds.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kStep = std::int64_t{1} << (ShearFrac - TileSlopeFrac), kMost = (std::int64_t{1} << ShearFrac) - 1;

class TileBounds : public ::testing::TestWithParam<Stalls> {
 protected:
  static std::vector<tile_bounds_t> run(const std::vector<CornerRays>& tiles, Stalls stalls = {}) {
    Dut<Vtile_bounds> dut;
    std::vector<ray_t> rays;
    for (const CornerRays& tile : tiles) rays.insert(rays.end(), tile.begin(), tile.end());
    const auto got = run_stream<tile_bounds_t>(dut, rays, tiles.size(), stalls);
    EXPECT_EQ(got.size(), tiles.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_TRUE(got[i] == tile_bounds(tiles[i])) << "\n rtl   " << to_text(got[i]) << "\n model " << to_text(tile_bounds(tiles[i]));
    return got;
  }
  // At a step, or up to two last bits beside it.
  shear_t slope() {
    const std::int64_t near = (static_cast<std::int64_t>(rng() % (2 * kMost / kStep)) - kMost / kStep) * kStep;
    return std::clamp<std::int64_t>(near + static_cast<std::int64_t>(rng() % 5) - 2, -kMost, kMost);
  }
  // Of one kind but for one tile in four.
  CornerRays tile() {
    CornerRays corners;
    const axis_t axis = static_cast<axis_t>(rng() % 3);
    const bool neg = rng() % 2, mixed = rng() % 4 == 0;
    for (ray_t& ray : corners) {
      ray.sx = slope(), ray.sy = slope();
      ray.axis = mixed && rng() % 4 == 0 ? static_cast<axis_t>(rng() % 3) : axis;
      ray.neg = mixed && rng() % 4 == 0 ? rng() % 2 : neg;
      ray.valid = !mixed || rng() % 8 != 0;
    }
    return corners;
  }
  std::mt19937_64 rng{5};
};
INSTANTIATE_TEST_SUITE_P(Stalls, TileBounds, ::testing::ValuesIn(kStallPatterns));

TEST_P(TileBounds, MatchesModel) {
  std::vector<CornerRays> tiles(3000);
  for (CornerRays& corners : tiles) corners = tile();
  run(tiles, GetParam());
}

TEST_F(TileBounds, LieALastBitBeyondTheCorners) {
  std::vector<CornerRays> tiles(3000);
  for (CornerRays& corners : tiles) corners = tile();
  const auto got = run(tiles);
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (!got[i].valid) continue;
    for (const ray_t& ray : tiles[i]) {
      const std::int64_t x = ray.neg ? -ray.sx : ray.sx, y = ray.neg ? -ray.sy : ray.sy;
      EXPECT_LE(got[i].x_low * kStep, x - 1);
      EXPECT_GE(got[i].x_high * kStep, x + 1);
      EXPECT_LE(got[i].y_low * kStep, y - 1);
      EXPECT_GE(got[i].y_high * kStep, y + 1);
    }
  }
}

TEST_F(TileBounds, KnowTheEndsOfTheFormat) {
  std::vector<CornerRays> tiles;
  for (const bool neg : {false, true})
    for (const shear_t s : {-kMost, -kMost + 1, kMost, std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}}) {
      CornerRays corners;
      for (ray_t& ray : corners) ray.sx = s, ray.sy = -s, ray.axis = 2, ray.neg = neg, ray.valid = 1;
      tiles.push_back(corners);
    }
  for (const tile_bounds_t& bounds : run(tiles)) EXPECT_TRUE(bounds.valid);
}

}  // namespace
}  // namespace castray::tb
