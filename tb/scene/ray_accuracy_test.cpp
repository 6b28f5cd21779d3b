// SPDX-License-Identifier: Apache-2.0
// Runs long.
// How far the model's rays lie from the exact ones, on the teapot's four views: the bounds of
// docs/number-formats.md, asserted for each ray; the largest errors seen are printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "scene/frame.hpp"

namespace castray::tb {
namespace {

using Real = long double;

struct View {
  const char* name;
  Vec3 eye, at;
};
const View kViews[] = {
    {"base", {5.439442, 11.080794, 10.381341}, {0.086994, 0.639098, -0.496275}},
    {"tight", {3.420837, 8.101608, 6.114639}, {0.217, 1.575, 0}},
    {"fit", {7.208649, 15.817841, 13.343781}, {0.217, 1.575, 0}},
    {"interior", {-1, 1.9, 0.7}, {1.6, 0.6, -0.5}},
};

// The largest errors of one frame, in units of the last bit of S or norm2.
struct Errors {
  Real division = 0;  // of S against the quotient of the direction in Q3.42
  Real camera = 0;    // of S against the exact camera
  Real norm = 0;      // of norm2 against 1 + Sx^2 + Sy^2
};

Scene scene_of(const View& view) {
  Scene scene;
  const Vec3 back = (view.eye - view.at).normalized(), right = Vec3(0, 1, 0).cross(back).normalized(), up = back.cross(right);
  scene.camera.field_of_view = 20;
  scene.camera.to_world = Matrix(right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, back.x, back.y, back.z, 0, view.eye.x, view.eye.y, view.eye.z, 1);
  return scene;
}

// The grid of the teapot seen from there.
Grid grid_of(const View& view) {
  Vec3 low = {-3, 0, -2}, high = {3.434, 3.15, 2};
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], view.eye[i]);
    high[i] = std::max(high[i], view.eye[i]);
  }
  return finest_grid(low, high);
}

Errors measure(const View& view, int width, int height) {
  const Scene scene = scene_of(view);
  const frame_record_t record = frame_record(scene, grid_of(view), width, height);
  const camera_t camera = frame_setup(record);

  // The exact camera, scaled as the record's: pitch is a power of two.
  const Real unit = std::ldexp(Real{1}, -26), half = unit / 2;
  const Real pitch = std::ldexp(static_cast<Real>(record.pitch), -ScaleFrac);
  const Real focal = pitch * height / std::tan(10 * std::numbers::pi_v<Real> / 180);
  const Vec3 r = scene.camera.right(), u = scene.camera.up(), k = scene.camera.back();

  Errors worst;
  long broken = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const dir_t dir = ray_gen(camera, x, y);
      const ray_t ray = ray_setup(dir, camera, {});
      const std::int64_t integer[3] = {dir.x, dir.y, dir.z};
      const int a = 2 * x + 1 - width, b = height - 2 * y - 1;
      const int axis = static_cast<int>(ray.axis), n0 = (axis + 1) % 3, n1 = (axis + 2) % 3;
      const auto exact = [&](int i) { return pitch * (a * static_cast<Real>(r[i]) + b * static_cast<Real>(u[i])) - focal * k[i]; };

      // Rounding of the matrix, of the focal length and of the steps, then a ratio.
      const Real component = std::ldexp(focal + pitch * (std::abs(a) + std::abs(b)), -31) + std::ldexp(Real{1}, -45) +
                             std::ldexp(static_cast<Real>(std::abs(a) + std::abs(b) + 1), -43);
      const Real dominant = std::abs(exact(axis));
      const int others[] = {n0, n1};
      const std::int64_t shear[] = {ray.sx, ray.sy};
      for (int i = 0; i < 2; ++i) {
        const Real s = shear[i] * unit;
        const bool clamped = std::abs(shear[i]) == (1 << 26) - 1;
        const Real division = std::abs(s - static_cast<Real>(integer[others[i]]) / integer[axis]);
        const Real camera_error = std::abs(s - exact(others[i]) / exact(axis));
        const Real limit = half + unit / 32 + (clamped ? half : 0);
        broken += division > limit;
        broken += camera_error > limit + 2 * component / (dominant - component);
        broken += camera_error > unit;  // the bound in round figures
        worst.division = std::max(worst.division, division / unit);
        worst.camera = std::max(worst.camera, camera_error / unit);
      }
      const Real norm2 = 1 + (ray.sx * unit) * (ray.sx * unit) + (ray.sy * unit) * (ray.sy * unit);
      const Real norm = std::abs(std::ldexp(static_cast<Real>(ray.norm2), -24) - norm2);
      broken += norm > std::ldexp(Real{1}, -25);
      worst.norm = std::max(worst.norm, norm / (4 * unit));
    }
  EXPECT_EQ(broken, 0) << view.name << ' ' << width << 'x' << height;
  return worst;
}

TEST(CameraAccuracy, StaysWithinItsBoundsOnTheFourViews) {
  std::printf("largest errors in last bits: S against the direction's quotient, S against the exact camera, norm2\n");
  for (const View& view : kViews)
    for (const auto& [width, height] : {std::array{320, 240}, {1920, 1080}}) {
      const Errors worst = measure(view, width, height);
      std::printf("  %-8s %4dx%-4d  %.4Lf  %.4Lf  %.4Lf   (grid 2^%d)\n", view.name, width, height, worst.division, worst.camera, worst.norm, grid_of(view).power);
    }
}

}  // namespace
}  // namespace castray::tb
