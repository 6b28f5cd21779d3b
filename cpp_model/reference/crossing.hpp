// SPDX-License-Identifier: Apache-2.0
// Where a line from the origin along d crosses a primitive, in multiples of d, for either type of number.
#pragma once
#include <ImathVec.h>

#include <cmath>
#include <limits>

namespace castray::reference {

// A triangle of corner a and edges b, c from it: Moller and Trumbore 1997.
template <class T> struct Crossing {
  T det;  // above zero where the corners run counter-clockwise as the line sees them
  T u;    // weight of the corner at a + b
  T v;    // of that at a + c
  T t;

  bool inside() const { return (det != 0) & (u >= 0) & (v >= 0) & (u + v <= 1); }
};

template <class T> Crossing<T> crossing(const Imath::Vec3<T>& a, const Imath::Vec3<T>& b, const Imath::Vec3<T>& c, const Imath::Vec3<T>& d) {
  const T px = d.y * c.z - d.z * c.y, py = d.z * c.x - d.x * c.z, pz = d.x * c.y - d.y * c.x;
  const T det = b.x * px + b.y * py + b.z * pz;
  const T inv = 1 / det;
  const T u = -(a.x * px + a.y * py + a.z * pz) * inv;
  const T qx = a.z * b.y - a.y * b.z, qy = a.x * b.z - a.z * b.x, qz = a.y * b.x - a.x * b.y;
  const T v = (d.x * qx + d.y * qy + d.z * qz) * inv;
  const T t = (c.x * qx + c.y * qy + c.z * qz) * inv;
  return {det, u, v, t};
}

// A sphere; not a number where the line passes outside. from_centre: the origin, from its centre.
template <class T> struct Roots {
  T near, far;
};

template <class T> Roots<T> roots(const Imath::Vec3<T>& from_centre, T radius, const Imath::Vec3<T>& d) {
  const T a = d.dot(d);
  const T b = from_centre.dot(d) / a;
  const Imath::Vec3<T> aside = from_centre - d * b;  // from the centre to the line, at right angles
  const T square = (radius * radius - aside.dot(aside)) / a;
  const T root = std::sqrt(square >= 0 ? square : std::numeric_limits<T>::quiet_NaN());
  return {-b - root, -b + root};
}

}  // namespace castray::reference
