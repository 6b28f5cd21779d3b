// SPDX-License-Identifier: Apache-2.0
#include "scene/made_scenes.hpp"

#include <cmath>
#include <random>

#include "scene/camera.hpp"
#include "scene/teapot.hpp"

namespace castray {
namespace {

const Vec3 kUp(0, 1, 0);

Mesh ground(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  mesh.points = {{low.x, 0, high.z}, {high.x, 0, high.z}, {high.x, 0, low.z}, {low.x, 0, low.z}};
  mesh.face_sizes = {4};
  mesh.corners = {0, 1, 2, 3};
  mesh.normals.assign(4, kUp);
  mesh.tex = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  return mesh;
}

void place(MadeScene& made, const std::string& file, const Matrix& to_world, Material material) {
  add_mesh(made.scene, made.files.at(file), to_world, material, file);
  made.scene.meshes.push_back({file, to_world, material});
}

}  // namespace

MadeScene made_teapot(int n, const std::string& stem) {
  MadeScene made;
  Scene& scene = made.scene;
  scene.file = stem + ".json";
  scene.description = "The Utah teapot at " + std::to_string(n) + " x " + std::to_string(n) + " cells a patch, base view";
  scene.camera.field_of_view = 20;
  look_at({5.439442, 11.080794, 10.381341}, {0.086994, 0.639098, -0.496275}, kUp, scene.camera.to_world);
  made.files[stem + ".geo"] = teapot_mesh(n);
  place(made, stem + ".geo", Matrix(), Material::Checker);
  return made;
}

MadeScene made_field(int columns, int rows, int n, const std::string& stem) {
  constexpr double kApart = 7;
  MadeScene made;
  Scene& scene = made.scene;
  scene.file = stem + ".json";
  scene.description = std::to_string(columns) + " x " + std::to_string(rows) + " teapots on a ground";
  const double width = columns * kApart, depth = rows * kApart;
  made.files[stem + "_ground.geo"] = ground({-width / 2, 0, -depth}, {width / 2, 0, 0});
  place(made, stem + "_ground.geo", Matrix(), Material::Checker);
  made.files[stem + ".geo"] = teapot_mesh(n);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int number = row * columns + column;
      Matrix at;
      at.setTranslation(Vec3((column + 0.5) * kApart - width / 2, 0, -(row + 0.5) * kApart));
      place(made, stem + ".geo", rotation(kUp, 137.5 * number) * at, static_cast<Material>(number % 3));
    }
  scene.camera.field_of_view = 40;
  look_at({width / 6, 2.5 * kApart, 2.5 * kApart}, {0, 0, -depth / 4}, kUp, scene.camera.to_world);
  return made;
}

MadeScene made_spheres(int count, unsigned seed) {
  MadeScene made;
  Scene& scene = made.scene;
  scene.file = "spheres.json";
  scene.description = std::to_string(count) + " spheres, seed " + std::to_string(seed);
  std::mt19937 random(seed);
  const auto unit = [&] { return double(random()) * 0x1p-32; };
  const double size = 10 / std::cbrt(count);  // about the distance of neighbours
  for (int i = 0; i < count; ++i) {
    Sphere sphere;
    for (int axis = 0; axis < 3; ++axis) sphere.centre[axis] = 10 * unit() - 5;
    sphere.radius = size * std::exp2(-4 * unit());
    sphere.material = static_cast<Material>(i % 3);
    scene.spheres.push_back(sphere);
  }
  scene.camera.field_of_view = 30;
  look_at({9, 7, 22}, Vec3(0), kUp, scene.camera.to_world);
  return made;
}

}  // namespace castray
