// SPDX-License-Identifier: Apache-2.0
// Why two tracers see different primitives at a pixel: in double, where its line passes the edge of
// the primitive that one of them missed, or how far apart two surfaces are there.
#pragma once
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace castray {

enum class Cause {
  Edge,       // the line passes the edge of the nearer one within float32's rounding
  Tie,        // both surfaces lie at the same distance, within float32's rounding
  Unexplained
};

struct Disagreement {
  int x = 0, y = 0;
  int ours = -1, theirs = -1;  // primitives, -1: none
  int float64 = -1;            // what the reference sees
  Cause cause = Cause::Unexplained;
  double distance = 0;         // of the line from the edge, or of the surfaces; scene units
  double rounding = 0;         // what float32 may move a line against a primitive there
};

// Compares the primitives that each pixel sees, row by row.
std::vector<Disagreement> disagreements(const Scene& scene, int width, int height, std::span<const int> ours, std::span<const int> theirs);

// The cause at one pixel.
Disagreement explain(const Scene& scene, int width, int height, int x, int y, int ours, int theirs);

}  // namespace castray
