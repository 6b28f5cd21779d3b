// SPDX-License-Identifier: Apache-2.0
// The .geo reader and writer: layouts, fans, white space, and each complaint by name.
#include "scene/geo.hpp"

#include "scene_test.hpp"

namespace castray {
namespace {

struct Geo : tb::SceneTest {
  std::string error(const std::string& text) const {
    return error_of([&] { parse_geo(text, "m.geo"); });
  }
};

// Two triangles over four points, of which one corner differs: F = 2, C = 6, V = 4.
const std::string kShape = "2  3 3  0 1 2 0 2 3  0 0 0  1 0 0  1 1 0  0 1 0 ";

std::string numbers(int count, int first = 1) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(first + i) + " ";
  return text;
}

TEST_F(Geo, NormalsAndTextureForEachCorner) {
  const Mesh mesh = parse_geo(kShape + numbers(18) + numbers(12, 101), "m.geo");
  EXPECT_EQ(mesh.points[2], Vec3(1, 1, 0));
  EXPECT_EQ(mesh.normals[4], Vec3(13, 14, 15));
  EXPECT_EQ(mesh.tex[4], Vec2(109, 110));
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST_F(Geo, NormalsForEachFaceTextureForEachPoint) {
  const Mesh mesh = parse_geo(kShape + numbers(6) + numbers(8, 101), "m.geo");
  EXPECT_EQ(mesh.normals[2], Vec3(1, 2, 3));
  EXPECT_EQ(mesh.normals[3], Vec3(4, 5, 6));
  EXPECT_EQ(mesh.tex[4], Vec2(105, 106));  // corner 4 is point 2
}

TEST_F(Geo, NormalsForEachPointTextureForEachPoint) {
  const Mesh mesh = parse_geo(kShape + numbers(12) + numbers(8, 101), "m.geo");
  EXPECT_EQ(mesh.normals[5], Vec3(10, 11, 12));
  EXPECT_EQ(mesh.tex[5], Vec2(107, 108));
}

TEST_F(Geo, NormalsForEachCornerTextureForEachPoint) {
  const Mesh mesh = parse_geo(kShape + numbers(18) + numbers(8, 101), "m.geo");
  EXPECT_EQ(mesh.normals[5], Vec3(16, 17, 18));
  EXPECT_EQ(mesh.tex[5], Vec2(107, 108));
}

TEST_F(Geo, NormalsForEachFaceTextureForEachCorner) {
  const Mesh mesh = parse_geo(kShape + numbers(6) + numbers(12, 101), "m.geo");
  EXPECT_EQ(mesh.normals[5], Vec3(4, 5, 6));
  EXPECT_EQ(mesh.tex[5], Vec2(111, 112));
}

TEST_F(Geo, NormalsForEachPointTextureForEachCorner) {
  const Mesh mesh = parse_geo(kShape + numbers(12) + numbers(12, 101), "m.geo");
  EXPECT_EQ(mesh.normals[3], Vec3(1, 2, 3));
  EXPECT_EQ(mesh.tex[3], Vec2(107, 108));
}

// A tetrahedron has as many faces as points: the report's layout is taken, and said so.
TEST_F(Geo, SaysWhatItTookWhenSeveralLayoutsFit) {
  const std::string text = "4 3 3 3 3  0 2 1 0 1 3 1 2 3 2 0 3  0 0 0 1 0 0 0 1 0 0 0 1 ";
  const Mesh mesh = parse_geo(text + numbers(12) + numbers(8, 101), "m.geo");
  EXPECT_EQ(mesh.normals[3], Vec3(4, 5, 6));
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_EQ(mesh.warnings[0],
            "m.geo: the number of values fits several layouts: normals taken for each face, texture coordinates for each point");
}

TEST_F(Geo, TokensOverAnyWhiteSpace) {
  const Mesh plain = parse_geo(tb::kTriangleGeo, "m.geo");
  std::string text = tb::kTriangleGeo;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == ' ') text[i] = "\n\t \r\v\f"[i % 6];
  const Mesh spread = parse_geo("\n\n" + text + "\n \n", "m.geo");
  EXPECT_EQ(plain.points, spread.points);
  EXPECT_EQ(plain.normals, spread.normals);
  EXPECT_EQ(parse_geo("+1 +3 0 +1 2  +1.5 -2e1 .5 1 0 0 0 1 0  0 0 1 0 0 1 0 0 1  0 0 1 0 0 1", "m.geo").points[0], Vec3(1.5, -20, 0.5));
}

TEST_F(Geo, FacesAreFans) {
  const std::string pentagon = "1 5 4 0 1 2 3  0 0 0 2 0 0 3 1 0 1 2 0 -1 1 0 ";
  const Scene scene = load_scene(put("m.geo", pentagon + "0 0 1 " + numbers(10)));
  ASSERT_EQ(scene.triangles.size(), 3u);
  const Vec3 fan[3][3] = {{{-1, 1, 0}, {0, 0, 0}, {2, 0, 0}}, {{-1, 1, 0}, {2, 0, 0}, {3, 1, 0}}, {{-1, 1, 0}, {3, 1, 0}, {1, 2, 0}}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(scene.triangles[i].corner[k], fan[i][k]) << i << " " << k;
  EXPECT_EQ(scene.triangles[1].tex[1], Vec2(3, 4));
  EXPECT_EQ(scene.triangles[1].normal[2], Vec3(0, 0, 1));
}

TEST_F(Geo, WhatIsWrittenReadsBack) {
  Mesh mesh = parse_geo(kShape + numbers(18) + numbers(12, 101), "m.geo");
  mesh.points[1] = {1.0 / 3, -1e-300, 12345.6789};
  mesh.normals[0] = {0.123456, -0.5, -0.0};
  const Mesh again = parse_geo(geo_text(mesh), "m.geo");
  EXPECT_EQ(again.points, mesh.points);
  EXPECT_EQ(again.corners, mesh.corners);
  EXPECT_EQ(again.tex, mesh.tex);
  EXPECT_EQ(again.normals[0], Vec3(0.12346, -0.5, 0));
}

// ---- Bad input ----

TEST_F(Geo, Missing) { EXPECT_EQ(error_of([&] { load_scene(folder_ / "none.geo"); }), "none.geo: open: no such file"); }
TEST_F(Geo, Folder) {
  std::filesystem::create_directory(folder_ / "d.geo");
  EXPECT_EQ(error_of([&] { load_scene(folder_ / "d.geo"); }), "d.geo: open: is a folder");
}
TEST_F(Geo, Empty) { EXPECT_EQ(error(" \n"), "m.geo: number of faces: the file ends after 0 of 1 values"); }
TEST_F(Geo, NoFaces) { EXPECT_EQ(error("0"), "m.geo: line 1, number of faces: 0 is not between 1 and 67108864"); }
TEST_F(Geo, AbsurdNumberOfFaces) {
  EXPECT_EQ(error("99999999999999999999 3"), "m.geo: line 1, number of faces: 99999999999999999999 is not between 1 and 67108864");
  EXPECT_EQ(error("60000000 3"), "m.geo: corners of each face: the file ends after 1 of 60000000 values");
}
TEST_F(Geo, TruncatedInFaces) { EXPECT_EQ(error("3\n3 3"), "m.geo: corners of each face: the file ends after 2 of 3 values"); }
TEST_F(Geo, TruncatedInCorners) { EXPECT_EQ(error("1\n3\n0 1"), "m.geo: points of the corners: the file ends after 2 of 3 values"); }
TEST_F(Geo, TruncatedInPoints) {
  EXPECT_EQ(error("1\n3\n0 1 2\n0 0 0 1"),
            "m.geo: point of corner 2: 2 is out of range, or the file is truncated: 9 coordinates are needed, 4 values follow");
}
TEST_F(Geo, TruncatedInNormals) {
  EXPECT_EQ(error("1\n3\n0 1 2\n0 0 0 1 0 0 0 1 0\n0 0 1 0"),
            "m.geo: normals and texture coordinates: 4 values follow the points; 15 are needed for 3 corners, and no other layout for "
            "1 face and 3 points has so many");
}
TEST_F(Geo, TruncatedAnywhere) {
  const std::string text = kShape + numbers(18) + numbers(12);
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i < text.size(); ++i)
    if (text[i] == ' ' && text[i - 1] != ' ') ends.push_back(i);
  int complete = 0;
  for (const std::size_t end : ends) complete += error(text.substr(0, end)) == "no error";
  EXPECT_EQ(complete, 6);  // the ends of the six layouts: 14, 18, 20, 24, 26 and 30 values
}
TEST_F(Geo, IndexOutOfRange) {
  EXPECT_EQ(error("1 3\n0 1 -1\n0 0 0"), "m.geo: line 2, point of corner 2: -1 is not between 0 and 67108863");
  EXPECT_EQ(error("1 3 0 1 67108864"), "m.geo: line 1, point of corner 2: 67108864 is not between 0 and 67108863");
  EXPECT_EQ(error("1 3 0 9 2 0 0 0 1 0 0 0 1 0  0 0 1 0 0 1 0 0 1  0 0 1 0 0 1"),
            "m.geo: point of corner 1: 9 is out of range, or the file is truncated: 30 coordinates are needed, 24 values follow");
}
TEST_F(Geo, IndexIsNoWholeNumber) { EXPECT_EQ(error("1 3\n0 1.5 2"), "m.geo: line 2, point of corner 1: '1.5' is not a whole number"); }
TEST_F(Geo, FaceOfTwoCorners) { EXPECT_EQ(error("2\n3 2\n0 1 2 0 1"), "m.geo: line 2, corners of face 1: 2 is not between 3 and 67108864"); }
TEST_F(Geo, CountThatDoesNotMatch) {
  EXPECT_EQ(error(std::string(tb::kTriangleGeo) + "7"),
            "m.geo: normals and texture coordinates: 16 values follow the points; 15 are needed for 3 corners, and no other layout for "
            "1 face and 3 points has so many");
}
TEST_F(Geo, TwoSigns) {
  EXPECT_EQ(error("1 3 0 1 +-2"), "m.geo: line 1, point of corner 2: '+-2' is not a whole number");
  EXPECT_EQ(error("1 3 0 1 2\n0 0 0 1 0 0 0 +-1 0"), "m.geo: line 2, point 2: '+-1' is not a number");
}
TEST_F(Geo, NotANumber) { EXPECT_EQ(error("1 3 0 1 2\n0 0 0 1 0 0\n0 x 0"), "m.geo: line 3, point 2: 'x' is not a number"); }
TEST_F(Geo, Nan) { EXPECT_EQ(error("1 3 0 1 2\n0 0 0 1 nan 0 0 1 0"), "m.geo: line 2, point 1: 'nan' is not a finite number"); }
TEST_F(Geo, Infinite) { EXPECT_EQ(error("1 3 0 1 2\n0 0 0 1 0 0 0 1 -inf"), "m.geo: line 2, point 2: '-inf' is not a finite number"); }
TEST_F(Geo, TooLargeForANumber) {
  EXPECT_EQ(error("1 3 0 1 2\n1e999 0 0 1 0 0 0 1 0"), "m.geo: line 2, point 0: '1e999' is outside the number range");
}
TEST_F(Geo, NanNormalAndTextureCoordinate) {
  const std::string shape = "1 3 0 1 2 0 0 0 1 0 0 0 1 0\n";
  EXPECT_EQ(error(shape + "0 0 1 0 nan 1 0 0 1\n0 0 1 0 0 1"), "m.geo: line 2, normal 1: 'nan' is not a finite number");
  EXPECT_EQ(error(shape + "0 0 1 0 0 1 0 0 1\n0 0 1 0 0 inf"), "m.geo: line 3, texture coordinate 2: 'inf' is not a finite number");
}
TEST_F(Geo, OutsideTheNumberRange) {
  EXPECT_EQ(load_error("m.geo", "1 3 0 1 2 0 0 0 1e30 0 0 0 1 0  0 0 1  0 0 1 0 0 1"), "m.geo: point 1: 1e+30 is outside the number range, +-2^60");
}
TEST_F(Geo, NoiseIsShownOnOneShortLine) {
  EXPECT_EQ(error("\x01\x02zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz"), "m.geo: line 1, number of faces: '  zzzzzzzzzzzzzzzzzzzzzz...' is not a whole number");
}

TEST_F(Geo, DegenerateTrianglesAreDroppedAndCounted) {
  const std::string text = "3 4 3 3  0 1 1 2  0 1 3  2 2 2   0 0 0 1 0 0 0 1 0 2 0 0 ";  // two slivers of the quad's three and both triangles
  const Scene scene = load_scene(put("m.geo", text + numbers(9) + numbers(8)));
  EXPECT_EQ(scene.triangles.size(), 1u);
  EXPECT_EQ(scene.dropped_triangles, 3u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], (folder_ / "m.geo").string() + ": 3 degenerate triangles dropped");
  EXPECT_EQ(load_error("n.geo", "1 3 0 1 1  0 0 0 1 1 1  0 0 1  0 0 0 0"), "n.geo: scene: all its triangles are degenerate");
}

}  // namespace
}  // namespace castray
