// SPDX-License-Identifier: Apache-2.0
// The float32 baseline sees what float64 sees, but for a few pixels at borders.
#include "reference/float32.hpp"

#include <gtest/gtest.h>

#include "scene/load.hpp"

namespace castray {
namespace {

void compare(const char* name, int most) {
  const Scene scene = load_scene(std::string("scenes/") + name + ".json");
  const ReferenceFrame exact = trace_float64(scene, 160, 120), single = trace_float32(scene, 160, 120);
  int differ = 0;
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    const ReferencePixel &a = exact.pixels[i], &b = single.pixels[i];
    if (a.prim != b.prim || a.odd != b.odd) {
      ++differ;
    } else if (a.prim >= 0) {
      EXPECT_NEAR(b.t / a.t, 1, 1e-4);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(b.colour[k], a.colour[k], 1);
    }
  }
  EXPECT_LE(differ, most);
}
TEST(Float32, Teapot) { compare("teapot", 10); }
TEST(Float32, Spheres) { compare("spheres", 10); }

}  // namespace
}  // namespace castray
