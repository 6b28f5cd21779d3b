// SPDX-License-Identifier: Apache-2.0
// Meshes that assimp would take for smaller ones, crash on or never end with: each is refused in one line that says where.
#include <cstring>

#include "scene_test.hpp"

namespace castray {
namespace {

using MeshCheck = tb::SceneTest;

// ---- PLY ----

std::string ply(const std::string& format, const std::string& faces, const std::string& body) {
  return "ply\nformat " + format + " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

// A number of T in one of the two orders of bytes.
template <class T> std::string bytes_of(T value, bool big_endian) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string binary_body(bool big_endian, std::uint8_t corners) {
  std::string body;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) body += bytes_of(x, big_endian);
  body += static_cast<char>(corners);
  for (const std::int32_t index : {0, 1, 2}) body += bytes_of(index, big_endian);
  return body;
}

TEST_F(MeshCheck, ATextPlyThatIsCutOff) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(load_error("m.ply", ply("ascii", "1", points + "3 0 1 2\n")), "no error");
  EXPECT_EQ(load_error("m.ply", ply("ascii", "1", points + "3 0 1 2")), "no error") << "the last line needs no end";
  EXPECT_EQ(load_error("m.ply", ply("ascii", "1", points + "3 0 1\n")), "m.ply: face 0: the file is truncated: it ends here");
  EXPECT_EQ(load_error("m.ply", ply("ascii", "2", points + "3 0 1 2\n")), "m.ply: face 1: the file is truncated: it ends here");
  EXPECT_EQ(load_error("m.ply", ply("ascii", "1", "0 0 0\n1 0 0\n0 1\n")), "m.ply: vertex 2: the file is truncated: it ends here");
  EXPECT_EQ(load_error("m.ply", ply("ascii", "1", points + "2000000000 0 1 2\n")), "m.ply: face 0: the file is truncated: it ends here");
  EXPECT_EQ(load_error("m.ply", ply("ascii", "1", points + "-3 0 1 2\n")), "m.ply: face 0: a list of -3 entries");
}

TEST_F(MeshCheck, ABinaryPlyThatIsCutOff) {
  for (const bool big_endian : {false, true}) {
    const std::string format = big_endian ? "binary_big_endian" : "binary_little_endian";
    SCOPED_TRACE(format);
    const std::string body = binary_body(big_endian, 3);
    EXPECT_EQ(load_error("m.ply", ply(format, "1", body)), "no error");
    for (const std::size_t left : {1, 4, 12})
      EXPECT_EQ(load_error("m.ply", ply(format, "1", body.substr(0, body.size() - left))), "m.ply: face 0: the file is truncated: it ends here");
    EXPECT_EQ(load_error("m.ply", ply(format, "1", body.substr(0, 36))), "m.ply: face 0: the file is truncated: it ends here");
    EXPECT_EQ(load_error("m.ply", ply(format, "1", body.substr(0, 35))), "m.ply: vertex 2: the file is truncated: it ends here");
    EXPECT_EQ(load_error("m.ply", ply(format, "1", binary_body(big_endian, 200))), "m.ply: face 0: the file is truncated: it ends here");
  }
}

// A list of more entries than the file has bytes: no memory is asked for it.
TEST_F(MeshCheck, ABinaryListBeyondTheFile) {
  for (const bool big_endian : {false, true}) {
    std::string text = ply(big_endian ? "binary_big_endian" : "binary_little_endian", "1", binary_body(big_endian, 3).substr(0, 36));
    text.replace(text.find("uchar"), 5, "uint");
    EXPECT_EQ(load_error("m.ply", text + bytes_of<std::uint32_t>(2'000'000'000, big_endian) + std::string(64, '\0')),
              "m.ply: face 0: the file is truncated: it ends here");
  }
}

// ---- STL ----

std::string solid(const std::string& name) {
  return "solid " + name + "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid " + name + "\n";
}

TEST_F(MeshCheck, ATextStlThatIsCutOff) {
  const std::string cause = "the file is truncated: it ends without endsolid", whole = solid("m");
  EXPECT_EQ(load_error("m.stl", whole), "no error");
  EXPECT_EQ(load_error("m.stl", whole.substr(0, whole.find("endsolid"))), "m.stl: line 9: " + cause);
  EXPECT_EQ(load_error("m.stl", whole.substr(0, whole.find("endfacet"))), "m.stl: line 8: " + cause);
  EXPECT_EQ(load_error("m.stl", whole + whole.substr(0, whole.find("endsolid"))), "m.stl: line 18: " + cause) << "the second solid";
  EXPECT_EQ(load_error("m.stl", "solid endsolid" + whole.substr(7, whole.find("endsolid") - 7)), "m.stl: line 9: " + cause);
}

TEST_F(MeshCheck, ATextStlOfAnyName) {
  for (const char* name : {"facet thing", "FACET NORMAL of it", "endsolid", "solid", ""}) EXPECT_EQ(load_error("m.stl", solid(name)), "no error") << name;
  EXPECT_EQ(load_scene(put("m.stl", solid("a") + solid("b"))).triangles.size(), 2u);
}

TEST_F(MeshCheck, ABinaryStlNeedsNoEnd) {
  std::string bytes = "solid" + std::string(75, ' ') + bytes_of<std::uint32_t>(1, false);
  for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += bytes_of(x, false);
  EXPECT_EQ(load_scene(put("m.stl", bytes + std::string(2, '\0'))).triangles.size(), 1u);
}

// ---- glTF ----

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string nodes(const std::string& list) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + list + "]}";
}

TEST_F(MeshCheck, GltfBracketsInBrackets) {
  const std::string deep = R"({"asset":{"version":"2.0"},"extras":)" + repeated("[", 100'000) + repeated("]", 100'000) + "}";
  EXPECT_EQ(load_error("m.gltf", deep), "m.gltf: byte 1035: more than 1000 brackets in each other");
  const std::string text = R"({"asset":{"version":"2.0"},"extras":")" + repeated("[\\\"", 2000) + "\"}";
  EXPECT_EQ(load_error("m.gltf", text).find("brackets"), std::string::npos) << "those of a text are none";
}

TEST_F(MeshCheck, GltfNodesBelowNodes) {
  std::string list = R"({"children":[1]})";
  for (int i = 2; i <= 100'000; ++i) list += R"(,{"children":[)" + std::to_string(i) + "]}";
  EXPECT_EQ(load_error("m.gltf", nodes(list + ",{}")), "m.gltf: node 1000: has more than 1000 nodes above it");
  EXPECT_EQ(load_error("m.gltf", nodes(R"({"children":[1]},{"children":[0]})")), "m.gltf: node 0: has more than 1000 nodes above it") << "a ring";
  EXPECT_EQ(load_error("m.gltf", nodes(R"({"children":[0]})")), "m.gltf: node 0: has more than 1000 nodes above it");
}

// Forty nodes that each name the next one twice are 2^40 to whoever follows them.
TEST_F(MeshCheck, GltfNodesOfTwoParents) {
  std::string list = R"({"children":[1,1]})";
  for (int i = 2; i <= 40; ++i) list += ",{\"children\":[" + std::to_string(i) + "," + std::to_string(i) + "]}";
  EXPECT_EQ(load_error("m.gltf", nodes(list + ",{}")), "m.gltf: node 1: is a child of the nodes 0 and 0: nodes must be a tree");
  EXPECT_EQ(load_error("m.gltf", nodes(R"({"children":[1,2]},{"children":[2]},{})")), "m.gltf: node 2: is a child of the nodes 0 and 1: nodes must be a tree");
}

TEST_F(MeshCheck, GlbLengthsBeyondTheFile) {
  const std::string json = nodes("{} ");
  const auto glb = [&](std::size_t length, std::size_t chunk) {
    return "glTF" + bytes_of<std::uint32_t>(2, false) + bytes_of(static_cast<std::uint32_t>(length), false) +
           bytes_of(static_cast<std::uint32_t>(chunk), false) + "JSON" + json;
  };
  const std::size_t size = 20 + json.size();
  const std::string left = std::to_string(json.size()), file = std::to_string(size);
  EXPECT_EQ(load_error("m.glb", glb(size, json.size())).find("announced"), std::string::npos);
  EXPECT_EQ(load_error("m.glb", glb(size + 1, json.size())), "m.glb: header: " + std::to_string(size + 1) + " bytes are announced, " + file + " are there: is the file truncated?");
  for (const std::size_t chunk : {json.size() + 1, std::size_t{0xffff'fff0}})
    EXPECT_EQ(load_error("m.glb", glb(size, chunk)), "m.glb: first chunk: " + std::to_string(chunk) + " bytes are announced, " + left + " are there: is the file truncated?");
  EXPECT_EQ(load_error("m.glb", glb(size, json.size()).substr(0, 19)), "m.glb: header: the file is truncated: 19 bytes");
}

// ---- Names ----

TEST_F(MeshCheck, NamesInAScene) {
  const auto error = [&](const std::string& name) { return load_error("s.json", R"({"meshes":[{"file":")" + name + "\"}]}"); };
  EXPECT_EQ(error(""), "s.json: meshes[0].file: is empty: the name of a mesh is needed");
  put("m.geo", tb::kTriangleGeo);
  EXPECT_EQ(error("m.geo"), "no error");
  EXPECT_EQ(error("m.geo\\u0000.obj"), "s.json: meshes[0].file: a file's name cannot hold a zero byte");
}

TEST_F(MeshCheck, ASuffixInCapitals) {
  EXPECT_EQ(load_error("S.JSON", "{}"), "S.JSON: scene: it holds no triangle and no sphere");
  EXPECT_EQ(load_error("M.GEO", tb::kTriangleGeo), "no error");
}

}  // namespace
}  // namespace castray
