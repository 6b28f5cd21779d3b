// SPDX-License-Identifier: Apache-2.0
// The reference: brute force in double over the scene, never over the image. It shares no table
// and no rounding with the model.
#pragma once
#include <functional>
#include <limits>
#include <vector>

#include "scene/scene.hpp"

namespace castray {

struct ReferencePixel {
  int prim = -1;  // -1: nothing is hit
  double t = std::numeric_limits<double>::infinity();  // distance from the eye, scene units
  double u = 0;   // weight of corner 0; spheres: 0
  double v = 0;   // weight of corner 1
  bool odd = false;  // parity of the checker's cell, whatever the material
  Rgb colour = {};
};

struct ReferenceFrame {
  int width = 0;
  int height = 0;
  std::vector<ReferencePixel> pixels;  // row by row, top first
  std::size_t hits = 0;

  const ReferencePixel& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

// Called from one thread at a time with the number of rows finished.
using RowProgress = std::function<void(int)>;

// threads == 0: as many as the machine has.
ReferenceFrame trace_float64(const Scene& scene, int width, int height, int threads = 0, const RowProgress& progress = {});
ReferencePixel trace_float64(const Scene& scene, int width, int height, int x, int y);

}  // namespace castray
