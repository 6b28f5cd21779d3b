// SPDX-License-Identifier: Apache-2.0
// A scene in world coordinates, as the references and the compiler of images take it.
// Primitive numbers: triangles in file order, then spheres.
#pragma once
#include <ImathMatrix.h>
#include <ImathVec.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "castray_records.hpp"
#include "scene/scene_error.hpp"

namespace castray {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;  // not initialised by default, as all of Imath's vectors
using Matrix = Imath::M44d;  // Imath's convention: row vectors, p' = p * M, translation in row 3

enum class Material : std::uint8_t { Checker = MaterialChecker, ColourA = MaterialA, ColourB = MaterialB };

struct Triangle {
  std::array<Vec3, 3> corner = {Vec3(0), Vec3(0), Vec3(0)};
  std::array<Vec3, 3> normal = {Vec3(0), Vec3(0), Vec3(0)};  // unit, or zero; where they cancel, the face's serves
  Vec3 face = Vec3(0);                                       // unit, on the side from which the corners run counter-clockwise
  std::array<Vec2, 3> tex = {Vec2(0), Vec2(0), Vec2(0)};
  Material material = Material::Checker;
};

struct Sphere {
  Vec3 centre = Vec3(0);
  double radius = 1;
  Material material = Material::Checker;
};

// Looks along -z of its own axes, x to the right, y up. The matrix may scale and mirror.
struct Camera {
  Matrix to_world;
  double field_of_view = 40;  // vertical, degrees

  Vec3 right() const { return {to_world[0][0], to_world[0][1], to_world[0][2]}; }
  Vec3 up() const { return {to_world[1][0], to_world[1][1], to_world[1][2]}; }
  Vec3 back() const { return {to_world[2][0], to_world[2][1], to_world[2][2]}; }
  Vec3 eye() const { return {to_world[3][0], to_world[3][1], to_world[3][2]}; }
};

using Rgb = std::array<std::uint8_t, 3>;

struct FrameSize {
  int width;
  int height;
};

enum class PixelFormat : std::uint8_t { Rgba8 = PixelRgba8, Bgra8 = PixelBgra8 };

struct Paint {
  Rgb background = {24, 28, 38};
  Rgb colour_a = {236, 228, 208};
  Rgb colour_b = {178, 60, 42};
  double checker_scale = 4;  // cells for each unit of texture coordinate, a multiple of 1/256
};

// Where triangles came from: what save_scene writes.
struct MeshSource {
  std::string file;
  Matrix object_to_world;
  Material material = Material::Checker;
};

struct Scene {
  std::string file;  // for messages
  std::string description;
  std::vector<MeshSource> meshes;
  std::vector<Triangle> triangles;
  std::vector<Sphere> spheres;
  Camera camera;
  int width = 320;
  int height = 240;
  PixelFormat pixel_format = PixelFormat::Rgba8;
  Paint paint;
  std::size_t dropped_triangles = 0;   // degenerate ones, not in `triangles`
  std::vector<std::string> warnings;   // one line each
  std::vector<std::string> defaults;   // "field of view 40 degrees": what the input left open

  std::size_t primitives() const { return triangles.size() + spheres.size(); }
};

}  // namespace castray
