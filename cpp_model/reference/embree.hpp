// SPDX-License-Identifier: Apache-2.0
// The rays of a frame through Embree, on one thread: what a tuned tracer in float32 does with them.
// Its scene is robust (watertight), its triangles and spheres are those of the scene, rounded to float.
#pragma once
#include <memory>
#include <vector>

#include "scene/scene.hpp"

namespace castray {

struct EmbreeFrame {
  std::vector<int> prims;  // that each pixel sees, row by row; -1: none
  double seconds = 0;      // of processor time for the intersections; the rays are made before
};

class Embree {
 public:
  explicit Embree(const Scene& scene);  // the scene is kept by reference
  ~Embree();

  double build_seconds() const;
  // `packet`: rays a call, 1, 4, 8 or 16; neighbouring pixels in blocks of 2x2, 4x2, 4x4.
  EmbreeFrame frame(int width, int height, int packet) const;

 private:
  struct Handles;
  const Scene& scene_;
  std::unique_ptr<Handles> handles_;
};

}  // namespace castray
