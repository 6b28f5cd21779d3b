// SPDX-License-Identifier: Apache-2.0
#include "scene/geo.hpp"

#include <algorithm>

#include "scene/files.hpp"
#include "scene/geo_tokens.hpp"

namespace castray {
namespace {

constexpr long long kMost = 1 << 26;  // faces, corners of a face, points

enum class Per { Corner, Face, Point };

struct Layout {
  Per normals;
  Per tex;
};

// In this order the first that fits is taken: what the report's files have comes first.
constexpr Layout kLayouts[] = {{Per::Corner, Per::Corner}, {Per::Face, Per::Point},   {Per::Corner, Per::Point},
                               {Per::Face, Per::Corner},   {Per::Point, Per::Point}, {Per::Point, Per::Corner}};

std::size_t count(Per per, const Mesh& mesh) {
  return per == Per::Corner ? mesh.corners.size() : per == Per::Face ? mesh.face_sizes.size() : mesh.points.size();
}
std::size_t values(const Layout& layout, const Mesh& mesh) { return 3 * count(layout.normals, mesh) + 2 * count(layout.tex, mesh); }

const char* name(Per per) { return per == Per::Corner ? "corner" : per == Per::Face ? "face" : "point"; }

// Gives each corner its normal and texture coordinates out of the values that follow the points.
void spread(const Layout& layout, const std::vector<double>& values, Mesh& mesh) {
  const std::size_t corners = mesh.corners.size();
  const std::size_t normals = count(layout.normals, mesh);
  mesh.normals.resize(corners);
  mesh.tex.resize(corners);
  std::size_t corner = 0;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    for (std::uint32_t k = 0; k < mesh.face_sizes[face]; ++k, ++corner) {
      const auto index = [&](Per per) { return per == Per::Corner ? corner : per == Per::Face ? face : mesh.corners[corner]; };
      for (std::size_t axis = 0; axis < 3; ++axis) mesh.normals[corner][axis] = values[3 * index(layout.normals) + axis];
      for (std::size_t axis = 0; axis < 2; ++axis) mesh.tex[corner][axis] = values[3 * normals + 2 * index(layout.tex) + axis];
    }
  }
}

// Faces, their corners and the points.
void read_shape(GeoTokens& tokens, Mesh& mesh, const std::string& file) {
  tokens.expect(1, "number of faces");
  const std::size_t faces = tokens.whole("number of faces", GeoTokens::kOnly, 1, kMost);
  tokens.expect(faces, "corners of each face");
  std::size_t corners = 0;
  for (std::size_t face = 0; face < faces; ++face) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(tokens.whole("corners of face", face, 3, kMost)));
    corners += mesh.face_sizes.back();
  }
  tokens.expect(corners, "points of the corners");
  std::size_t last = 0;  // the corner with the largest index
  for (std::size_t corner = 0; corner < corners; ++corner) {
    mesh.corners.push_back(static_cast<std::uint32_t>(tokens.whole("point of corner", corner, 0, kMost - 1)));
    if (mesh.corners[corner] > mesh.corners[last]) last = corner;
  }
  const std::size_t points = mesh.corners[last] + std::size_t{1};
  if (tokens.left() < 3 * points)
    throw SceneError(file, "point of corner " + std::to_string(last),
                     std::to_string(points - 1) + " is out of range, or the file is truncated: " + std::to_string(3 * points) +
                         " coordinates are needed, " + std::to_string(tokens.left()) + " values follow");
  mesh.points.resize(points);
  for (std::size_t i = 0; i < points; ++i)
    for (int axis = 0; axis < 3; ++axis) mesh.points[i][axis] = tokens.real("point", i);
}

// Normals and texture coordinates, in the first layout that fits.
void read_rest(GeoTokens& tokens, Mesh& mesh, const std::string& file) {
  const std::size_t left = tokens.left();
  const auto fits = [&](const Layout& layout) { return values(layout, mesh) == left; };
  const Layout* const layout = std::find_if(std::begin(kLayouts), std::end(kLayouts), fits);
  if (layout == std::end(kLayouts))
    throw SceneError(file, "normals and texture coordinates",
                     std::to_string(left) + " values follow the points; " + std::to_string(5 * mesh.corners.size()) + " are needed for " +
                         counted(mesh.corners.size(), "corner") + ", and no other layout for " + counted(mesh.face_sizes.size(), "face") +
                         " and " + counted(mesh.points.size(), "point") + " has so many");
  std::vector<double> rest(left);
  const std::size_t normal_values = 3 * count(layout->normals, mesh);
  for (std::size_t i = 0; i < left; ++i)
    rest[i] = i < normal_values ? tokens.real("normal", i / 3) : tokens.real("texture coordinate", (i - normal_values) / 2);
  spread(*layout, rest, mesh);

  // The plain layout comes first; any other is a guess where a further one would say otherwise.
  if (layout == std::begin(kLayouts)) return;
  for (const Layout* other = layout + 1; other != std::end(kLayouts); ++other) {
    if (!fits(*other)) continue;
    Mesh otherwise = mesh;
    spread(*other, rest, otherwise);
    if (otherwise.normals == mesh.normals && otherwise.tex == mesh.tex) continue;
    mesh.warnings.push_back(file + ": the number of values fits several layouts: normals taken for each " + name(layout->normals) +
                            ", texture coordinates for each " + name(layout->tex));
    return;
  }
}

}  // namespace

Mesh parse_geo(const std::string& text, const std::string& file) {
  GeoTokens tokens(text, file);
  Mesh mesh;
  read_shape(tokens, mesh, file);
  read_rest(tokens, mesh, file);
  return mesh;
}

Mesh read_geo(const std::filesystem::path& path) { return parse_geo(read_file(path), path.string()); }

}  // namespace castray
