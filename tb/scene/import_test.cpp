// SPDX-License-Identifier: Apache-2.0
// OBJ, PLY, STL and glTF through assimp, each from a small file.
#include <cstring>

#include "scene_test.hpp"

namespace castray {
namespace {

struct Import : tb::SceneTest {
  Scene load(const std::string& name, const std::string& text) const { return load_scene(put(name, text)); }
};

void expect_corners(const Triangle& triangle, const Vec3& a, const Vec3& b, const Vec3& c) {
  EXPECT_EQ(triangle.corner[0], a);
  EXPECT_EQ(triangle.corner[1], b);
  EXPECT_EQ(triangle.corner[2], c);
}

TEST_F(Import, ObjWithNormalsAndTexture) {
  const Scene scene = load("m.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nvn 0 1 1\nvt 0.25 0.5\nvt 1 0\nf 1/1/1 2/2/1 3/1/1\n");
  ASSERT_EQ(scene.triangles.size(), 1u);
  expect_corners(scene.triangles[0], {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  EXPECT_NEAR(scene.triangles[0].normal[1].y, std::sqrt(0.5), 1e-7);
  EXPECT_EQ(scene.triangles[0].face, Vec3(0, 0, 1));
  EXPECT_EQ(scene.triangles[0].tex[0], Vec2(0.25, 0.5));
  EXPECT_EQ(scene.triangles[0].tex[1], Vec2(1, 0));
}

TEST_F(Import, ObjWithoutNormalsAndTextureGetsFacesAndZeros) {
  const Scene scene = load("m.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n");
  ASSERT_EQ(scene.triangles.size(), 2u);
  for (const Triangle& triangle : scene.triangles)
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(triangle.normal[i], Vec3(0, 0, 1));
      EXPECT_EQ(triangle.tex[i], Vec2(0, 0));
    }
}

TEST_F(Import, Ply) {
  const Scene scene = load("m.ply",
                           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 0 -1\n3 0 1 2\n");
  ASSERT_EQ(scene.triangles.size(), 1u);
  expect_corners(scene.triangles[0], {0, 0, 0}, {1, 0, 0}, {0, 0, -1});
  EXPECT_EQ(scene.triangles[0].normal[0], Vec3(0, 1, 0));
}

TEST_F(Import, Stl) {
  const Scene scene = load("m.stl", "solid m\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid m\n");
  ASSERT_EQ(scene.triangles.size(), 1u);
  expect_corners(scene.triangles[0], {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
}

// The node moves and mirrors its mesh: what was outside stays outside.
TEST_F(Import, GltfWithANode) {
  std::string buffer(36 + 8, '\0');
  const float points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint16_t indices[] = {0, 1, 2};
  std::memcpy(buffer.data(), points, 36);
  std::memcpy(buffer.data() + 36, indices, 6);
  put("m.bin", buffer);
  const Scene scene = load("m.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"mesh":0,"scale":[-2,1,1],"translation":[5,0,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "buffers":[{"uri":"m.bin","byteLength":44}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
                 {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})");
  ASSERT_EQ(scene.triangles.size(), 1u);
  expect_corners(scene.triangles[0], {5, 1, 0}, {3, 0, 0}, {5, 0, 0});
  EXPECT_EQ(scene.triangles[0].face, Vec3(0, 0, 1));
}

// ---- Bad input ----

TEST_F(Import, Missing) { EXPECT_EQ(error_of([&] { load_scene(folder_ / "none.obj"); }), "none.obj: open: no such file"); }
TEST_F(Import, UnknownFormat) {
  EXPECT_EQ(load_error("m.xyz", "hello"), "m.xyz: file name: unknown format \".xyz\"; known are .geo .obj .ply .stl .gltf .glb");
}
TEST_F(Import, NotAMesh) { EXPECT_EQ(load_error("m.ply", "hello").substr(0, 15), "m.ply: import: "); }
TEST_F(Import, PlyHeaders) {
  const std::string face = "property float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n";
  const std::string data = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto error = [&](const std::string& count, const std::string& rest) {
    return load_error("m.ply", "ply\nformat ascii 1.0\nelement vertex " + count + "\n" + rest);
  };
  EXPECT_EQ(error("3", face + data), "no error");
  EXPECT_EQ(error("3", face), "m.ply: header: has no end_header");
  EXPECT_EQ(load_error("m.ply", "ply"), "m.ply: header: has no end_header");
  EXPECT_EQ(error("2000000000", face + data), "m.ply: header: 2000000001 elements are announced, 26 bytes follow");
  for (const std::string count : {"-3", "x", "3.5", "", "99999999999999999999"})
    EXPECT_EQ(error(count, face + data), "m.ply: line 3: '" + count + "' is not a number of elements");
}
TEST_F(Import, FaceWithoutCorners) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(load_error("m.ply", header + "3 0 1 2\n0\n"), "m.ply: face 1: has no corners");
}
TEST_F(Import, NoFaces) { EXPECT_NE(load_error("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "no error"); }
TEST_F(Import, IndexOutOfRange) { EXPECT_EQ(load_error("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").substr(0, 15), "m.obj: import: "); }
TEST_F(Import, Nan) {
  EXPECT_EQ(load_error("m.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "m.obj: point 1: nan is not a finite number");
}
TEST_F(Import, LinesAreIgnoredAndCounted) {
  const Scene scene = load("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
  EXPECT_EQ(scene.triangles.size(), 1u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], (folder_ / "m.obj").string() + ": 1 point or line ignored");
}

}  // namespace
}  // namespace castray
