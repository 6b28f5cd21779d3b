// SPDX-License-Identifier: Apache-2.0
#include "reference/disagreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/float64.hpp"
#include "reference/pixel_ray.hpp"

namespace castray {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// Corners, eye and direction are each rounded to 24 bits, and the test itself takes some steps.
constexpr double kRoundings = 8 * 0x1p-24;

struct Line {
  Vec3 from, along;  // along: of unit length
};

// How a line meets a primitive, whether inside its edge or not.
struct Meeting {
  double t = kFar;       // where it crosses the primitive, or passes its edge
  double edge = kFar;    // distance of the line from the edge: of a triangle's sides, of a sphere's outline
  double facing = 1;     // cosine between line and normal
  double reach = 0;      // the largest coordinate, or distance, that took part
};

struct Passing {
  double distance, t;
};
Passing passing(const Line& line, const Vec3& a, const Vec3& b) {
  const Vec3 side = b - a;
  // The side as the line sees it: what is left at right angles to it.
  const auto across = [&](const Vec3& v) { return v - line.along * v.dot(line.along); };
  const Vec3 from = across(line.from - a), flat = across(side);
  const double length2 = flat.dot(flat);
  const double at = length2 > 0 ? std::clamp(from.dot(flat) / length2, 0.0, 1.0) : 0;
  return {(from - flat * at).length(), (a + side * at - line.from).dot(line.along)};
}

Meeting meeting(const Line& line, const Triangle& triangle) {
  Meeting m;
  const auto& [a, b, c] = triangle.corner;
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const double facing = line.along.dot(normal);
  m.facing = std::abs(facing);
  m.t = (a - line.from).dot(normal) / facing;
  const Vec3 crossing = line.from + line.along * m.t;
  bool inside = true;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &from = triangle.corner[i], &to = triangle.corner[(i + 1) % 3];
    inside &= (to - from).cross(crossing - from).dot(normal) >= 0;
  }
  for (int i = 0; i < 3; ++i) {
    const Passing side = passing(line, triangle.corner[i], triangle.corner[(i + 1) % 3]);
    if (!inside && side.distance < m.edge) m.t = side.t;
    m.edge = std::min(m.edge, side.distance);
  }
  for (const Vec3& corner : triangle.corner)
    m.reach = std::max({m.reach, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z), (corner - line.from).length()});
  return m;
}

Meeting meeting(const Line& line, const Sphere& sphere) {
  Meeting m;
  const Vec3 to_centre = sphere.centre - line.from;
  const double along = to_centre.dot(line.along);
  const double aside = (to_centre - line.along * along).length();
  const double half = std::sqrt(std::max(0.0, sphere.radius * sphere.radius - aside * aside));
  m.t = along - half > 0 ? along - half : along + half;
  m.edge = std::abs(sphere.radius - aside);
  m.facing = half / sphere.radius;
  m.reach = std::max({std::abs(sphere.centre.x), std::abs(sphere.centre.y), std::abs(sphere.centre.z)}) + sphere.radius + to_centre.length();
  return m;
}

}  // namespace

Disagreement explain(const Scene& scene, int width, int height, int x, int y, int ours, int theirs) {
  Disagreement result{.x = x, .y = y, .ours = ours, .theirs = theirs, .float64 = trace_float64(scene, width, height, x, y).prim};
  const Line line{scene.camera.eye(), pixel_direction(scene, width, height, x, y).normalized()};
  const auto meet = [&](int prim) {
    const std::size_t number = static_cast<std::size_t>(prim), triangles = scene.triangles.size();
    return prim < 0 ? Meeting() : number < triangles ? meeting(line, scene.triangles[number]) : meeting(line, scene.spheres[number - triangles]);
  };
  const Meeting a = meet(ours), b = meet(theirs);
  // One of them saw the nearer one, and the other went by: at its edge, or because both are equally near.
  const Meeting& nearer = a.t <= b.t ? a : b;
  const Vec3 eye = line.from;
  const double reach = std::max({a.reach, b.reach, std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
  result.rounding = kRoundings * reach;
  result.distance = nearer.edge;
  if (nearer.edge <= result.rounding) {
    result.cause = Cause::Edge;
  } else if (std::abs(a.t - b.t) <= result.rounding * (1 / a.facing + 1 / b.facing)) {
    result.distance = std::abs(a.t - b.t);
    result.cause = Cause::Tie;
  }
  return result;
}

std::vector<Disagreement> disagreements(const Scene& scene, int width, int height, std::span<const int> ours, std::span<const int> theirs) {
  std::vector<Disagreement> found;
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (ours[i] != theirs[i]) {
      const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
      found.push_back(explain(scene, width, height, x, y, ours[i], theirs[i]));
    }
  return found;
}

}  // namespace castray
