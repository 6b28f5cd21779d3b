// SPDX-License-Identifier: Apache-2.0
// A triangle with the normal of its face at each corner.
#pragma once
#include "scene/scene.hpp"

namespace castray::tb {

inline Triangle flat_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  Triangle made;
  made.corner = {a, b, c};
  made.face = (b - a).cross(c - a).normalized();
  made.normal = {made.face, made.face, made.face};
  return made;
}

}  // namespace castray::tb
