// SPDX-License-Identifier: Apache-2.0
// The Utah teapot: Martin Newell's 32 bicubic Bezier patches, with y up: (x, y, z) -> (x, z, -y).
#pragma once
#include <array>

#include "scene/mesh.hpp"

namespace castray {

// One patch: control points [row along v][column along u], counter-clockwise u to v from outside.
using BezierPatch = std::array<std::array<Vec3, 4>, 4>;

std::array<BezierPatch, 32> teapot_patches();

// Each patch as n x n cells: quadrilaterals, triangles where a side has shrunk to a point. Points on
// common borders are shared exactly; normals are those of the surface; texture coordinates are the
// patch's parameters. n = 10 gives 3,241 points and 6,320 triangles.
Mesh teapot_mesh(int n);

}  // namespace castray
