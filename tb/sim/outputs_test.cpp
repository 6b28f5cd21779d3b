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
