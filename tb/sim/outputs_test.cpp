// SPDX-License-Identifier: Apache-2.0
// The files that the program was asked to write: refused before any work is done where they cannot be
// written, are one and the same, or are an input.
// Cores: l3c32t3p2m128
#include "command_line.hpp"

namespace castray::tb {
namespace {

TEST_F(CommandLine, UnwritableOutputs) {
  const std::string none = path("none/out.png");
  expect_refused("render scenes/cube.json --engine model -o " + none, 6, {none});
  expect_refused("render scenes/cube.json --engine model -o " + path("out.nonsense"), 6, {"out.nonsense"});
  expect_refused("render scenes/cube.json --engine model -o " + path("out"), 2, {"suffix"});
  const std::string good = "render scenes/cube.json --engine model -o " + path("out.png");
  for (const std::string aov : {"a.png", "a.tif", "a"}) expect_refused(good + " --aov " + path(aov), 6, {aov});
  fs::create_directory(path("folder"));
  for (const std::string option : {"--aov", "--json", "--hits", "--frame", "--save-scene"})
    for (const std::string name : {"folder", "none/file"}) expect_refused(good + " " + option + " " + path(name), 6, {path(name)});
  for (const std::string name : {"folder", "none/t.fst"}) {
    expect_refused("render scenes/cube.json --trace-window 1:9 -o " + path("out.png") + " --trace " + path(name), 6, {path(name)});
    expect_refused("ray scenes/cube.json 1 1 --trace " + path(name), 6, {path(name)});
  }
}

// What OpenImageIO calls a format, but which holds no picture of three channels, not one of this size, or is no file.
TEST_F(CommandLine, FormatsThatHoldNoSuchPicture) {
  for (const std::string suffix : {"null", "zfile", "term", "ico"}) {
    const std::string name = path("a." + suffix);
    expect_refused("render scenes/cube.geo --size 300x20 --engine model -o " + name, 6, {name});
    expect_refused("render scenes/cube.geo --size 300x20 --engine model -o " + path("a.png") + " --tests-map " + name, 6, {name});
  }
  expect_refused("render scenes/cube.geo --size 8x8 --engine model -o " + path("a.png") + " --nodes-map " + path("a.ico"), 6, {"a.ico", "320 x 361"});
  for (const std::string suffix : {"ppm", "jpg", "tif", "bmp", "exr"})
    EXPECT_EQ(run("render scenes/cube.json --size 8x8 --engine model -o " + path("a." + suffix)).code, 0) << suffix;
}

TEST_F(CommandLine, EmptyNamesOfOutputs) {
  const std::string good = " scenes/cube.geo --size 8x8 --engine model";
  for (const std::string option : {"--output", "-o", "--aov", "--json", "--frame", "--hits", "--nodes-map", "--tests-map", "--save-scene", "--trace"})
    expect_refused("render" + good + " " + option + " ''", 2, {"name is empty"});
  const std::string rays = file("rays.csv", "ox,oy,oz,dx,dy,dz\n0,0,5,0,0,-1\n");
  for (const std::string option : {"--output", "--json", "--trace"}) expect_refused("query" + good + " " + rays + " " + option + " ''", 2, {"name is empty"});
  expect_refused("ray scenes/cube.geo 1 1 --trace ''", 2, {"name is empty"});
  expect_refused("compile scenes/cube.geo --output ''", 2, {"name is empty"});
}

TEST_F(CommandLine, ANameAsLongAsANameMayBe) {
  const std::string name = std::string(251, 'n') + ".png";
  EXPECT_EQ(run("render scenes/cube.json --size 8x8 --engine model -o " + path(name) + " --json " + path(std::string(255, 'j'))).code, 0);
  EXPECT_TRUE(fs::exists(path(name)));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
  expect_refused("render scenes/cube.json --size 8x8 --engine model -o " + path("n" + name), 6, {"too long"});
}

TEST_F(CommandLine, OutputsThatAreOneFile) {
  const std::string good = "render scenes/cube.json --engine model -o " + path("out.png");
  expect_refused(good + " --json " + path("out.png"), 2, {"--json", "--output"});
  expect_refused(good + " --hits " + path("a") + " --frame " + path("x/../a"), 2, {"--hits", "--frame"});
  fs::create_symlink("out.png", path("link"));
  expect_refused(good + " --frame " + path("link"), 2, {"--frame", "--output"});
}

TEST_F(CommandLine, OutputsThatAreInputs) {
  fs::copy("scenes/cube.geo", path("cube.geo"));
  const std::string text = R"({"meshes": [{"file": "cube.geo"}]})", scene = file("cube.json", text);
  const std::string mesh = read(path("cube.geo")), good = "render " + scene + " --engine model --size 8x8 -o " + path("out.png");
  for (const std::string option : {"--json", "--save-scene", "--frame"}) expect_refused(good + " " + option + " " + scene, 2, {option, "scene"});
  expect_refused(good + " --hits " + path("cube.geo"), 2, {"--hits", "mesh"});
  EXPECT_EQ(read(scene), text);
  EXPECT_EQ(read(path("cube.geo")), mesh);
}

TEST_F(CommandLine, StandardOutputIsFull) {
  expect_needs_output("info scenes/cube.json");
  expect_needs_output("render scenes/cube.json --engine model --size 8x8 -o " + path("out.png"));
}

}  // namespace
}  // namespace castray::tb
