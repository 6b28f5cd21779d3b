// SPDX-License-Identifier: Apache-2.0
// A view of the width study: its frame in float64, and by a nearest-hit search of other arithmetic.
#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "reference/float64.hpp"
#include "reference/pixel_ray.hpp"
#include "scene/load.hpp"

namespace castray::width {

inline constexpr int kWidth = 320, kHeight = 240, kTile = 16;

struct Pixel {
  std::int32_t prim = -1;
  Rgb colour = {};
};

struct View {
  Scene scene;
  std::vector<Pixel> reference;   // row by row
};

// Traced once: later runs read `folder`/name.float64.
inline View load_view(const std::string& name, const std::filesystem::path& folder) {
  View view{load_scene("scenes/" + name + ".json"), std::vector<Pixel>(kWidth * kHeight)};
  const std::filesystem::path file = folder / (name + ".float64");
  const auto bytes = static_cast<std::streamsize>(view.reference.size() * sizeof(Pixel));
  if (std::ifstream in(file, std::ios::binary); in && in.read(reinterpret_cast<char*>(view.reference.data()), bytes)) return view;
  const ReferenceFrame frame = trace_float64(view.scene, kWidth, kHeight);
  std::ranges::transform(frame.pixels, view.reference.begin(), [](const ReferencePixel& p) { return Pixel{p.prim, p.colour}; });
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(view.reference.data()), bytes);
  return view;
}

// For each tile of kTile x kTile pixels the primitives that a ray through it may meet, `slack` scene units beside them:
// those whose corners' pixels, and kTile / 2 around, touch it. What reaches behind the eye may be anywhere, as may spheres.
inline std::vector<std::vector<std::size_t>> tile_lists(const Scene& scene, double slack) {
  constexpr int kColumns = kWidth / kTile, kRows = kHeight / kTile;
  std::vector<std::vector<std::size_t>> tiles(kColumns * kRows);
  const double focal = kHeight / 2 / std::tan(scene.camera.field_of_view * std::numbers::pi / 360);   // pixels
  for (std::size_t i = 0; i < scene.primitives(); ++i) {
    double low[2] = {0, 0}, high[2] = {kWidth, kHeight};
    if (i < scene.triangles.size()) {
      double at[2][3], depth[3];
      for (int k = 0; k < 3; ++k) {
        const Vec3 v = scene.triangles[i].corner[k] - scene.camera.eye();
        depth[k] = -v.dot(scene.camera.back());
        at[0][k] = kWidth / 2 + focal * v.dot(scene.camera.right()) / depth[k];
        at[1][k] = kHeight / 2 - focal * v.dot(scene.camera.up()) / depth[k];
      }
      if (const double nearest = *std::min_element(depth, depth + 3); nearest > 4 * slack) {
        const double around = kTile / 2 + focal * slack / (nearest - slack);
        for (int axis = 0; axis < 2; ++axis) {
          low[axis] = *std::min_element(at[axis], at[axis] + 3) - around;
          high[axis] = *std::max_element(at[axis], at[axis] + 3) + around;
        }
      }
    }
    const auto tile = [](double pixel, int count) { return static_cast<int>(std::clamp(std::floor(pixel / kTile), -1.0, double(count))); };
    for (int y = std::max(0, tile(low[1], kRows)); y <= std::min(kRows - 1, tile(high[1], kRows)); ++y)
      for (int x = std::max(0, tile(low[0], kColumns)); x <= std::min(kColumns - 1, tile(high[0], kColumns)); ++x)
        tiles[static_cast<std::size_t>(y * kColumns + x)].push_back(i);
  }
  return tiles;
}

// Against the reference.
struct Errors {
  int wrong = 0;     // pixels that see another primitive
  double psnr = 0;   // of the colours, dB; infinite where all are equal
};

// pixel(tile's number, x, y) of each.
template <class PixelAt> Errors errors(const View& view, PixelAt&& pixel_at) {
  Errors out;
  double squares = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const Pixel& want = view.reference[static_cast<std::size_t>(y * kWidth + x)];
      const Pixel got = pixel_at(static_cast<std::size_t>(y / kTile * (kWidth / kTile) + x / kTile), x, y);
      out.wrong += got.prim != want.prim;
      for (int k = 0; k < 3; ++k) squares += std::pow(double(got.colour[k]) - double(want.colour[k]), 2);
    }
  out.psnr = 10 * std::log10(255.0 * 255 * 3 * kWidth * kHeight / squares);
  return out;
}

}  // namespace castray::width
