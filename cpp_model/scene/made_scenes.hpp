// SPDX-License-Identifier: Apache-2.0
// Scenes of any size, made by rule: what build/make_scene writes and the bench renders.
#pragma once
#include <map>
#include <string>

#include "scene/mesh.hpp"

namespace castray {

// A scene with its meshes by file name; its `meshes` name those files.
struct MadeScene {
  Scene scene;
  std::map<std::string, Mesh> files;
};

// File names begin with `stem`.
// The teapot at n x n cells a patch, seen from the base view: 64 n (n - 1) + 56 n triangles
// for n of 2 and more.
MadeScene made_teapot(int n, const std::string& stem);
// Teapots in rows on a ground, turned this way and that.
MadeScene made_field(int columns, int rows, int n, const std::string& stem);
// Spheres of many sizes, scattered in a cube; the same seed gives the same ones on every machine.
MadeScene made_spheres(int count, unsigned seed);

}  // namespace castray
