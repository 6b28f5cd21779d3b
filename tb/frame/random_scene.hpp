// SPDX-License-Identifier: Apache-2.0
// Seeded random scenes for whole frames: triangles and spheres, every signed dominant axis, cameras
// among the primitives and inside spheres, duplicates at equal distances.
#pragma once
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "scene/scene.hpp"

namespace castray::tb {

struct RandomScene {
  Scene scene;
  bool ties = false;  // primitives that coincide: which of them wins is no question for float64
  std::string text;   // what it is, for messages
};

class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : seed_(seed), random_(seed * 2654435761u + 1) {}

  RandomScene make() {
    static constexpr int kSizes[][2] = {{1, 1}, {7, 5}, {33, 17}};
    RandomScene result;
    Scene& scene = result.scene;
    scene.file = "seed " + std::to_string(seed_);
    const auto [width, height] = kSizes[seed_ % 3];
    scene.width = width;
    scene.height = height;
    const int axis = static_cast<int>(seed_ / 3 % 3);
    const double sign = seed_ / 9 % 2 ? -1 : 1;
    const bool inside = seed_ / 18 % 2;
    result.ties = seed_ % 5 == 0;
    place_camera(scene, axis, sign, inside);
    const int triangles = pick(1, 40), spheres = pick(0, 8);
    for (int i = 0; i < triangles; ++i) scene.triangles.push_back(triangle(scene));
    for (int i = 0; i < spheres; ++i) scene.spheres.push_back(sphere(scene, inside && i == 0));
    if (result.ties) duplicate(scene);
    choose_paint(scene);
    result.text = scene.file + ": " + std::to_string(width) + "x" + std::to_string(height) + " along " + (sign < 0 ? "-" : "+") +
                  "xyz"[axis] + (inside ? ", from inside" : "") + (result.ties ? ", with ties" : "") + ", " +
                  std::to_string(scene.triangles.size()) + " triangles, " + std::to_string(scene.spheres.size()) + " spheres";
    return result;
  }

 private:
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool one_in(int n) { return pick(1, n) == 1; }
  Vec3 box(double half) { return {real(-half, half), real(-half, half), real(-half, half)}; }
  Vec3 unit() {
    for (;;) {
      const Vec3 v = box(1);
      if (v.length() > 0.1) return v.normalized();
    }
  }

  // Looks along the signed axis, a little off it, so that most rays have that dominant axis and some another.
  void place_camera(Scene& scene, int axis, double sign, bool inside) {
    Vec3 ahead = box(0.35);
    ahead[axis] = sign;
    ahead.normalize();
    const Vec3 right = ahead.cross(unit()).normalized();
    const Vec3 up = right.cross(ahead).normalized();
    const Vec3 eye = inside ? box(0.5) : Vec3(ahead * -real(4, 9));
    Matrix& m = scene.camera.to_world;
    m.makeIdentity();
    for (int i = 0; i < 3; ++i) {
      m[0][i] = right[i];
      m[1][i] = up[i];
      m[2][i] = -ahead[i];
      m[3][i] = eye[i];
    }
    scene.camera.field_of_view = real(15, inside ? 110 : 60);
  }

  Material material() { return static_cast<Material>(pick(0, 2)); }

  Triangle triangle(const Scene& scene) {
    Triangle t;
    t.material = material();
    const Vec3 centre = box(2);
    const double size = one_in(4) ? 2.5 : real(0.05, 1);
    for (Vec3& corner : t.corner) corner = centre + box(size);
    if (one_in(6)) t.corner[2] = t.corner[0] + (t.corner[1] - t.corner[0]) * 0.5 + box(1e-3);  // a sliver
    if (one_in(6)) {                                                                       // in an axis' plane
      const int axis = pick(0, 2);
      for (Vec3& corner : t.corner) corner[axis] = centre[axis];
    }
    if (!scene.triangles.empty() && one_in(3)) {  // shares an edge with the one before
      t.corner[0] = scene.triangles.back().corner[1];
      t.corner[1] = scene.triangles.back().corner[0];
    }
    const Vec3 area = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
    if (area.length() < 1e-4) return triangle(scene);
    t.face = area.normalized();
    const int kind = pick(0, 3);  // face normals, smooth ones, ones that cancel, none
    const Vec3 side = unit();
    for (int i = 0; i < 3; ++i) {
      t.normal[i] = kind == 0 ? t.face : kind == 1 ? (t.face + box(0.6)).normalized() : kind == 2 ? (i == 0 ? side : -side) : Vec3(0);
      t.tex[i] = {real(-2, 3), real(-2, 3)};
    }
    return t;
  }

  Sphere sphere(const Scene& scene, bool around_eye) {
    Sphere s;
    s.material = material();
    s.centre = around_eye ? scene.camera.eye() + box(0.3) : box(2.5);
    s.radius = around_eye ? real(0.8, 3) : real(0.05, 1.2);
    return s;
  }

  // Copies at the same place, under later and so under higher numbers, with another look.
  void duplicate(Scene& scene) {
    const std::size_t triangles = scene.triangles.size();
    for (std::size_t i = 0; i < triangles; i += 2) {
      Triangle copy = scene.triangles[i];
      copy.material = material();
      if (i % 4 == 0) {
        std::swap(copy.corner[1], copy.corner[2]);  // the same points, the other way round
        copy.face = -copy.face;
      }
      scene.triangles.push_back(copy);
    }
    if (!scene.spheres.empty()) scene.spheres.push_back(scene.spheres.front());
  }

  void choose_paint(Scene& scene) {
    const auto colour = [&] { return Rgb{static_cast<std::uint8_t>(pick(0, 255)), static_cast<std::uint8_t>(pick(0, 255)), static_cast<std::uint8_t>(pick(0, 255))}; };
    scene.paint = {colour(), colour(), colour(), pick(1, 4096) / 256.0};
    scene.pixel_format = one_in(2) ? PixelFormat::Bgra8 : PixelFormat::Rgba8;
  }

  unsigned seed_;
  std::mt19937 random_;
};

inline RandomScene random_scene(unsigned seed) { return SceneMaker(seed).make(); }

}  // namespace castray::tb
