// SPDX-License-Identifier: Apache-2.0
// The tracer behind float64.hpp and float32.hpp, for either type of number.
//   triangle: Moller and Trumbore 1997, both sides; sphere: nearer root in front of the eye, else
//   the farther; nearest hit, equal distances to the lower number.
//   colour: texture colour x |n . d|, n the normalised interpolated normal (zero: the face's).
#pragma once
#include <cmath>
#include <numbers>

#include "parallel.hpp"
#include "reference/float64.hpp"
#include "reference/triangle_list.hpp"

namespace castray::reference {

template <class T> class Tracer {
  using V = Imath::Vec3<T>;
  static constexpr T kFar = std::numeric_limits<T>::infinity();

 public:
  Tracer(const Scene& scene, int width, int height)
      : scene_(scene), width_(width), height_(height), right_(scene.camera.right()), up_(scene.camera.up()),
        back_(scene.camera.back()), tangent_(T(std::tan(scene.camera.field_of_view * std::numbers::pi / 360))), triangles_(scene, eye()) {}

  ReferencePixel pixel(int x, int y) const {
    const T across = (2 * (x + T(0.5)) / width_ - 1) * tangent_ * (T(width_) / height_);
    const T above = (1 - 2 * (y + T(0.5)) / height_) * tangent_;
    const V d = right_ * across + up_ * above - back_;
    const T length = std::sqrt(d.dot(d));
    ReferencePixel pixel;
    pixel.colour = scene_.paint.background;
    if (!(length > 0)) return pixel;

    T nearest = kFar;
    triangles_.nearest([&](std::size_t i) {
      const Crossing<T> at = triangles_.cross(i, V(0), d);
      return (at.inside() & (at.t > 0)) ? at.t : kFar;
    }, nearest, pixel.prim);
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i) {
      const T t = sphere(scene_.spheres[i], d);
      if (t < nearest) {
        nearest = t;
        pixel.prim = static_cast<int>(scene_.triangles.size() + i);
      }
    }
    if (pixel.prim < 0) return pixel;
    pixel.t = double(nearest) * double(length);
    shade(pixel, d, length, nearest);
    return pixel;
  }

 private:
  T sphere(const Sphere& sphere, const V& d) const {
    const Roots<T> at = roots(V(eye() - sphere.centre), T(sphere.radius), d);
    return at.near > 0 ? at.near : at.far > 0 ? at.far : kFar;
  }

  void shade(ReferencePixel& pixel, const V& d, T length, T t) const {
    V n;
    T s, q;
    Material material;
    if (std::size_t(pixel.prim) < scene_.triangles.size()) {
      const Triangle& triangle = scene_.triangles[std::size_t(pixel.prim)];
      T u, v;
      weights(std::size_t(pixel.prim), d, u, v);
      const T w = 1 - u - v;
      pixel.u = u;
      pixel.v = v;
      n = V(triangle.normal[0]) * u + V(triangle.normal[1]) * v + V(triangle.normal[2]) * w;
      if (n.dot(n) == 0) n = V(triangle.face);
      n = n / std::sqrt(n.dot(n));
      s = T(triangle.tex[0].x) * u + T(triangle.tex[1].x) * v + T(triangle.tex[2].x) * w;
      q = T(triangle.tex[0].y) * u + T(triangle.tex[1].y) * v + T(triangle.tex[2].y) * w;
      material = triangle.material;
    } else {
      const Sphere& sphere = scene_.spheres[std::size_t(pixel.prim) - scene_.triangles.size()];
      n = V(eye() - sphere.centre) + d * t;
      n = n / std::sqrt(n.dot(n));
      s = (n.x + 1) / 2;
      q = (n.y + 1) / 2;
      material = sphere.material;
    }
    const T scale = T(scene_.paint.checker_scale);
    const auto cell = [&](T x) { return static_cast<long long>(std::floor(x * scale)); };
    pixel.odd = ((cell(s) ^ cell(q)) & 1) != 0;
    const bool second = material == Material::Checker ? pixel.odd : material == Material::ColourB;
    const Rgb& colour = second ? scene_.paint.colour_b : scene_.paint.colour_a;
    const T facing = std::min(T(1), std::abs(n.dot(d)) / length);
    for (int i = 0; i < 3; ++i) pixel.colour[i] = static_cast<std::uint8_t>(std::floor(colour[i] * facing + T(0.5)));
  }

  // The weights of corners 0 and 1 where the line d meets triangle i.
  void weights(std::size_t i, const V& d, T& u, T& v) const {
    const V a = triangles_.corner(i), b = triangles_.edge_b(i), c = triangles_.edge_c(i);
    const V p = d.cross(c);
    const T det = b.dot(p);
    const T of_b = -a.dot(p) / det;
    const T of_c = d.dot(b.cross(a)) / det;
    u = 1 - of_b - of_c;
    v = of_b;
  }

  Vec3 eye() const { return scene_.camera.eye(); }

  const Scene& scene_;
  int width_, height_;
  V right_, up_, back_;
  T tangent_;
  TriangleList<T> triangles_;  // corners from the eye
};

template <class T> ReferenceFrame trace(const Scene& scene, int width, int height, int threads, const RowProgress& progress) {
  const Tracer<T> tracer(scene, width, height);
  ReferenceFrame frame;
  frame.width = width;
  frame.height = height;
  frame.pixels.resize(std::size_t(width) * std::size_t(height));
  parallel(std::size_t(height), threads,
           [&](std::size_t y) {
             std::size_t hits = 0;
             for (int x = 0; x < width; ++x) {
               ReferencePixel& pixel = frame.pixels[y * std::size_t(width) + std::size_t(x)];
               pixel = tracer.pixel(x, static_cast<int>(y));
               hits += pixel.prim >= 0;
             }
             return hits;
           },
           [&](std::size_t, std::size_t hits, std::size_t finished) {
             frame.hits += hits;
             if (progress) progress(static_cast<int>(finished));
             return true;
           });
  return frame;
}

}  // namespace castray::reference
