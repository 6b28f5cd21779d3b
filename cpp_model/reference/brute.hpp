// SPDX-License-Identifier: Apache-2.0
// The tracer behind float64.hpp and float32.hpp, for either type of number.
//   triangle: Moller and Trumbore 1997, both sides; sphere: nearer root in front of the eye, else
//   the farther; nearest hit, equal distances to the lower number.
//   colour: texture colour x |n . d|, n the normalised interpolated normal (zero: the face's).
#pragma once
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <thread>

#include "reference/crossing.hpp"
#include "reference/float64.hpp"

namespace castray::reference {

template <class T> class Tracer {
  using V = Imath::Vec3<T>;
  static constexpr T kFar = std::numeric_limits<T>::infinity();
  static constexpr std::size_t kBlock = 64;

 public:
  Tracer(const Scene& scene, int width, int height)
      : scene_(scene), width_(width), height_(height), right_(scene.camera.right()), up_(scene.camera.up()),
        back_(scene.camera.back()), tangent_(T(std::tan(scene.camera.field_of_view * std::numbers::pi / 360))) {
    const std::size_t count = (scene.triangles.size() + kBlock - 1) / kBlock * kBlock;
    for (auto& axis : data_) axis.resize(count);  // padding: triangles of no area, never hit
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
      const auto& [a, b, c] = scene.triangles[i].corner;
      for (int k = 0; k < 3; ++k) {
        data_[k][i] = T(a[k] - eye()[k]);
        data_[3 + k][i] = T(b[k] - a[k]);
        data_[6 + k][i] = T(c[k] - a[k]);
      }
    }
  }

  ReferencePixel pixel(int x, int y) const {
    const T across = (2 * (x + T(0.5)) / width_ - 1) * tangent_ * (T(width_) / height_);
    const T above = (1 - 2 * (y + T(0.5)) / height_) * tangent_;
    const V d = right_ * across + up_ * above - back_;
    const T length = std::sqrt(d.dot(d));
    ReferencePixel pixel;
    pixel.colour = scene_.paint.background;
    if (!(length > 0)) return pixel;

    T nearest = kFar;
    triangles(d, nearest, pixel.prim);
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
  // A block of tests at a time, written so that the compiler makes vectors of them.
  void triangles(const V& d, T& nearest, int& prim) const {
    const std::size_t count = data_[0].size();
    for (std::size_t first = 0; first < count; first += kBlock) {
      std::array<T, kBlock> t;
      const auto at_first = [&](int k) { return data_[k].data() + first; };
      const T *ax = at_first(0), *ay = at_first(1), *az = at_first(2);
      const T *bx = at_first(3), *by = at_first(4), *bz = at_first(5);
      const T *cx = at_first(6), *cy = at_first(7), *cz = at_first(8);
      int any = 0;
      for (std::size_t i = 0; i < kBlock; ++i) {
        const Crossing<T> at = crossing({ax[i], ay[i], az[i]}, {bx[i], by[i], bz[i]}, {cx[i], cy[i], cz[i]}, d);
        const bool hit = at.inside() & (at.t > 0);
        t[i] = hit ? at.t : kFar;
        any |= t[i] < nearest;
      }
      if (!any) continue;
      for (std::size_t i = 0; i < kBlock; ++i) {
        if (t[i] < nearest) {
          nearest = t[i];
          prim = static_cast<int>(first + i);
        }
      }
    }
  }

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
    const V a(data_[0][i], data_[1][i], data_[2][i]), b(data_[3][i], data_[4][i], data_[5][i]), c(data_[6][i], data_[7][i], data_[8][i]);
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
  std::array<std::vector<T>, 9> data_;  // corner 0 from the eye, two edges; by component
};

template <class T> ReferenceFrame trace(const Scene& scene, int width, int height, int threads, const RowProgress& progress) {
  const Tracer<T> tracer(scene, width, height);
  ReferenceFrame frame;
  frame.width = width;
  frame.height = height;
  frame.pixels.resize(std::size_t(width) * std::size_t(height));
  std::atomic<int> next = 0;
  std::mutex mutex;
  int finished = 0;
  const auto work = [&] {
    for (int y = next++; y < height; y = next++) {
      std::size_t hits = 0;
      for (int x = 0; x < width; ++x) {
        ReferencePixel& pixel = frame.pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        pixel = tracer.pixel(x, y);
        hits += pixel.prim >= 0;
      }
      const std::lock_guard lock(mutex);
      frame.hits += hits;
      ++finished;
      if (progress) progress(finished);
    }
  };
  const int wanted = threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<std::thread> pool;
  for (int i = 1; i < std::min(wanted, height); ++i) pool.emplace_back(work);
  work();
  for (std::thread& thread : pool) thread.join();
  return frame;
}

}  // namespace castray::reference
