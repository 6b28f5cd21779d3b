// SPDX-License-Identifier: Apache-2.0
#include "scene/geo.hpp"

#include <algorithm>
#include <cmath>

#include "scene/files.hpp"
#include "scene/text.hpp"

namespace castray {
namespace {

constexpr std::size_t kMaxPoints = std::size_t{1} << 26;

// The tokens of a .geo file, one after the other.
class Tokens {
 public:
  Tokens(const std::string& text, const std::string& file) : at_(text.data()), end_(at_ + text.size()), file_(file) {
    left_ = 0;
    bool inside = false;
    for (const char* c = at_; c != end_; ++c) {
      left_ += !is_space(*c) && !inside;
      inside = !is_space(*c);
    }
  }

  std::size_t left() const { return left_; }
  int line() const { return line_; }

  // `what` and `number` name the place: "face 3".
  double real(const char* what, std::size_t number) {
    const std::string_view token = next(what, number);
    double value = 0;
    const auto read = std::from_chars(token.data() + (token[0] == '+'), token.data() + token.size(), value);
    if (read.ec == std::errc::result_out_of_range) fail(what, number, "'" + std::string(token) + "' is outside the number range");
    if (read.ec != std::errc() || read.ptr != token.data() + token.size()) fail(what, number, "'" + shown(token) + "' is not a number");
    if (!std::isfinite(value)) fail(what, number, "'" + std::string(token) + "' is not a finite number");
    return value;
  }

  std::size_t whole(const char* what, std::size_t number, std::size_t least, std::size_t most, const char* cause) {
    const std::string_view token = next(what, number);
    long long value = 0;
    const auto read = std::from_chars(token.data() + (token[0] == '+'), token.data() + token.size(), value);
    const bool too_long = read.ec == std::errc::result_out_of_range;
    if (!too_long && (read.ec != std::errc() || read.ptr != token.data() + token.size()))
      fail(what, number, "'" + shown(token) + "' is not a whole number");
    if (too_long || value < static_cast<long long>(least) || value > static_cast<long long>(most))
      fail(what, number, std::string(token) + " " + cause);
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] void fail(const char* what, std::size_t number, const std::string& cause) const {
    throw SceneError(file_, "line " + std::to_string(line_) + ", " + what + " " + std::to_string(number), cause);
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static std::string shown(std::string_view token) {
    return one_line(std::string(token.substr(0, 24))) + (token.size() > 24 ? "..." : "");
  }

  std::string_view next(const char* what, std::size_t number) {
    for (; at_ != end_ && is_space(*at_); ++at_) line_ += *at_ == '\n';
    if (at_ == end_) fail(what, number, "the file ends here");
    const char* from = at_;
    while (at_ != end_ && !is_space(*at_)) ++at_;
    --left_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }

  const char* at_;
  const char* end_;
  const std::string& file_;
  std::size_t left_ = 0;
  int line_ = 1;
};

enum class Per { Corner, Face, Point };

struct Layout {
  Per normals;
  Per tex;
};

// In this order the first that fits is taken: what the report's files have comes first.
constexpr Layout kLayouts[] = {{Per::Corner, Per::Corner}, {Per::Face, Per::Point},   {Per::Corner, Per::Point},
                               {Per::Face, Per::Corner},   {Per::Point, Per::Point}, {Per::Point, Per::Corner}};

}  // namespace

Mesh parse_geo(const std::string& text, const std::string& file) {
  Tokens tokens(text, file);
  Mesh mesh;
  if (tokens.left() == 0) throw SceneError(file, "line 1", "the file is empty");

  const std::size_t faces = tokens.whole("the number of faces, value", 0, 1, kMaxPoints, "is not between 1 and 67108864");
  if (tokens.left() < faces)
    throw SceneError(file, "corners of each face", "the file ends after " + std::to_string(tokens.left()) + " of " + std::to_string(faces) + " values");
  std::size_t corners = 0;
  mesh.face_sizes.reserve(faces);
  for (std::size_t face = 0; face < faces; ++face) {
    const std::size_t size = tokens.whole("face", face, 3, kMaxPoints, "corners: a face has at least three and at most 67108864");
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(size));
    corners += size;
  }
  if (tokens.left() < corners)
    throw SceneError(file, "point of each corner", "the file ends after " + std::to_string(tokens.left()) + " of " + std::to_string(corners) + " values");

  std::size_t largest = 0;
  std::size_t largest_corner = 0;
  mesh.corners.reserve(corners);
  for (std::size_t corner = 0; corner < corners; ++corner) {
    const std::size_t point = tokens.whole("corner", corner, 0, kMaxPoints - 1, "is out of range: points are numbered from 0 to at most 67108863");
    mesh.corners.push_back(static_cast<std::uint32_t>(point));
    if (point > largest) {
      largest = point;
      largest_corner = corner;
    }
  }
  const std::size_t points = largest + 1;
  if (tokens.left() < 3 * points)
    throw SceneError(file, "corner " + std::to_string(largest_corner),
                     "point " + std::to_string(largest) + " is out of range, or the file is truncated: " + std::to_string(3 * points) +
                         " coordinates needed, " + std::to_string(tokens.left()) + " values follow");

  mesh.points.resize(points);
  for (std::size_t i = 0; i < points; ++i)
    for (int axis = 0; axis < 3; ++axis) mesh.points[i][axis] = tokens.real("point", i);

  const auto count = [&](Per per) { return per == Per::Corner ? corners : per == Per::Face ? faces : points; };
  const auto values = [&](const Layout& layout) { return 3 * count(layout.normals) + 2 * count(layout.tex); };
  const std::size_t left = tokens.left();
  const auto* layout = std::find_if(std::begin(kLayouts), std::end(kLayouts), [&](const Layout& one) { return values(one) == left; });
  if (layout == std::end(kLayouts))
    throw SceneError(file, "normals and texture coordinates",
                     std::to_string(left) + " values follow the points, " + std::to_string(5 * corners) + " are needed for " +
                         counted(corners, "corner") + "; no other count fits " + counted(faces, "face") + " and " + counted(points, "point") + " either");
  const bool several = std::any_of(layout + 1, std::end(kLayouts), [&](const Layout& other) { return values(other) == left; });
  if (layout != std::begin(kLayouts) && several) {
    const auto name = [](Per per) { return per == Per::Corner ? "corner" : per == Per::Face ? "face" : "point"; };
    mesh.warnings.push_back(file + ": the number of values fits several layouts; taken as a normal for each " + name(layout->normals) +
                            " and texture coordinates for each " + name(layout->tex));
  }

  std::vector<Vec3> normals(count(layout->normals));
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) normals[i][axis] = tokens.real("normal", i);
  std::vector<Vec2> tex(count(layout->tex));
  for (std::size_t i = 0; i < tex.size(); ++i)
    for (int axis = 0; axis < 2; ++axis) tex[i][axis] = tokens.real("texture coordinate", i);

  mesh.normals.reserve(corners);
  mesh.tex.reserve(corners);
  std::size_t corner = 0;
  for (std::size_t face = 0; face < faces; ++face) {
    for (std::uint32_t k = 0; k < mesh.face_sizes[face]; ++k, ++corner) {
      const auto index = [&](Per per) { return per == Per::Corner ? corner : per == Per::Face ? face : mesh.corners[corner]; };
      mesh.normals.push_back(normals[index(layout->normals)]);
      mesh.tex.push_back(tex[index(layout->tex)]);
    }
  }
  return mesh;
}

Mesh read_geo(const std::filesystem::path& path) { return parse_geo(read_file(path), path.string()); }

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
