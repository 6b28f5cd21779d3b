// SPDX-License-Identifier: Apache-2.0
// Heat maps: none is black, most is brightest, and more is never darker; the scale below has its ends.
#include "heat_map.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace castray::tb {
namespace {

namespace fs = std::filesystem;

class HeatMap : public testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }
  sim::Picture map(int width, int height, const std::vector<std::uint32_t>& values) {
    sim::write_heat_map(file_, width, height, values, "nodes a pixel", {});
    return sim::read_picture(file_);
  }
  static int brightness(const sim::Picture& picture, int x, int y) {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return picture.rgb[at] + picture.rgb[at + 1] + picture.rgb[at + 2];
  }
  const fs::path file_ = fs::temp_directory_path() / ("castray_heat_" + std::to_string(getpid()) + ".png");
};

TEST_F(HeatMap, MoreIsBrighter) {
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 400; ++i) values.insert(values.end(), {i, 399});
  const sim::Picture picture = map(800, 1, values);
  EXPECT_EQ(picture.width, 800);
  EXPECT_GT(picture.height, 20) << "a scale belongs below";
  EXPECT_LT(brightness(picture, 0, 0), 10);
  int last = 0;
  for (int x = 0; x < 800; x += 2) {
    EXPECT_GE(brightness(picture, x, 0), last - 2) << x;
    last = brightness(picture, x, 0);
    EXPECT_GT(brightness(picture, x + 1, 0), 400);
  }
}

TEST_F(HeatMap, SmallFramesAreEnlargedByAWholeFactor) {
  const sim::Picture picture = map(3, 2, {0, 9, 0, 9, 0, 9});
  EXPECT_EQ(picture.width, 3 * 107);
  for (int y : {0, 106, 107, 213})
    for (int x : {0, 106, 107, 213, 214, 320}) EXPECT_EQ(brightness(picture, x, y) > 300, (x / 107 + y / 107) % 2 == 1) << x << ", " << y;
}

// One column of many rows is not enlarged until it is as wide as its scale.
TEST_F(HeatMap, TallFramesStaySmall) {
  std::vector<std::uint32_t> values(4096, 0);
  values[4000] = 9;
  const sim::Picture picture = map(1, 4096, values);
  EXPECT_EQ(picture.width, 320);
  EXPECT_LT(picture.height, 4096 + 64);
  EXPECT_GT(brightness(picture, 159, 4000), 400) << "in the middle of the sheet";
  EXPECT_LT(brightness(picture, 159, 3999), 10);
}

// The bar of the scale goes from none to most, and letters stand below it.
TEST_F(HeatMap, HasItsScaleBelow) {
  const sim::Picture picture = map(320, 10, std::vector<std::uint32_t>(3200, 0));
  EXPECT_LT(brightness(picture, 6, 16), 60);
  EXPECT_GT(brightness(picture, 313, 16), 300);
  int letters = 0;
  for (int y = 10 + 20; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) letters += brightness(picture, x, y) > 400;
  EXPECT_GT(letters, 100);
}

TEST_F(HeatMap, ThatCannotBeWrittenIsRefused) {
  EXPECT_THROW(sim::write_heat_map("/no/such/folder/a.png", 1, 1, std::vector<std::uint32_t>{1}, "nodes", {}), sim::PictureError);
}

}  // namespace
}  // namespace castray::tb
