// SPDX-License-Identifier: Apache-2.0
// Matrices of scenes and cameras.
#pragma once
#include "scene/scene.hpp"

namespace castray {

// Camera-to-world of an eye that looks at a point; `up` lies in the picture's vertical plane.
// Returns false when the three do not define one.
bool look_at(const Vec3& eye, const Vec3& target, const Vec3& up, Matrix& to_world);

// Frames the scene: seen from in front, a little from the right and from above, with the whole of
// its bounding sphere inside the picture. Returns false when it is too small for where it lies: rounding
// leaves no distance.
bool frame_scene(Scene& scene);

// The box of all primitives. The scene must not be empty.
void bounds(const Scene& scene, Vec3& low, Vec3& high);

// Rotation about an axis through the origin; exact for quarter turns about a coordinate axis.
Matrix rotation(const Vec3& axis, double degrees);

// Sixteen numbers row by row for column vectors (translation in the last column), and back.
Matrix from_rows(const std::array<double, 16>& rows);
std::array<double, 16> to_rows(const Matrix& matrix);

}  // namespace castray
