// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scene/geo.hpp"
#include "scene/text.hpp"

namespace castray {

std::string geo_text(const Mesh& mesh) {
  std::string text = std::to_string(mesh.face_sizes.size()) + "\n";
  std::size_t on_line = 0;
  const auto put = [&](const std::string& token) {
    text += token;
    text += ++on_line % 24 == 0 ? '\n' : ' ';
  };
  const auto end_section = [&] {
    text.back() = '\n';
    on_line = 0;
  };
  const auto rounded = [](double x) {
    std::string token = text_of(std::round(x * 1e5) / 1e5);
    if (token == "-0") token = "0";
    if (token.starts_with("0.")) token.erase(0, 1);
    if (token.starts_with("-0.")) token.erase(1, 1);
    return token;
  };
  for (const std::uint32_t size : mesh.face_sizes) put(std::to_string(size));
  end_section();
  for (const std::uint32_t point : mesh.corners) put(std::to_string(point));
  end_section();
  for (const Vec3& point : mesh.points)
    for (int axis = 0; axis < 3; ++axis) put(text_of(point[axis]));
  end_section();
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) put(rounded(mesh.normals.empty() ? 0 : mesh.normals[i][axis]));
  end_section();
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    for (int axis = 0; axis < 2; ++axis) put(rounded(mesh.tex.empty() ? 0 : mesh.tex[i][axis]));
  end_section();
  return text;
}

}  // namespace castray
