// SPDX-License-Identifier: Apache-2.0
// Lanes with unlike work: one whose queue is full holds up the others, and nothing of it is lost.
// Cores: l3c32t3p2m128
#include <cmath>
#include <numbers>

#include "frame/frame.hpp"

namespace castray::tb {
namespace {

// Two pixels, of which one sees a row of spheres, each of them hit, and the other nothing. A pixel is
// a lane's only ray, so a primitive is tested in every cycle, and a root takes many.
Scene spheres_seen_by(int pixel) {
  Scene scene;
  scene.width = 2, scene.height = 1;
  const double aside = std::tan(scene.camera.field_of_view * std::numbers::pi / 360) * (pixel == 0 ? -1 : 1);
  for (int i = 0; i < 150; ++i) {
    Sphere sphere;
    const double depth = 4 + 0.05 * ((i * 37 + 75) % 150);  // the nearest is neither the first nor the last
    sphere.centre = {aside * depth, 0, -depth};
    sphere.radius = 0.8;
    scene.spheres.push_back(sphere);
  }
  return scene;
}

TEST(Lanes, AFullOneHoldsUpTheOthers) {
  for (const std::string stalls : {"none", "uniform"}) {
    Core core(core_of(3, stalls));
    for (const int pixel : {0, 1}) {
      SCOPED_TRACE("pixel " + std::to_string(pixel) + ", stalls " + stalls);
      const SceneImage image = compile(spheres_seen_by(pixel), 2, 1);
      expect_frame(core, image, {.mode = sim::Mode::kBrute});
      const sim::Rendering rtl = core.driver.render({.mode = sim::Mode::kBrute});
      EXPECT_EQ(rtl.counters[CntCandidates], 150u);
      EXPECT_EQ(rtl.counters[CntHits], 1u);
    }
  }
}

}  // namespace
}  // namespace castray::tb
