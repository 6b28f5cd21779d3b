// SPDX-License-Identifier: Apache-2.0
// castray compile from outside: the bytes that the core is given, as a file.
#include "command_line.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

TEST_F(CommandLine, CompileWritesTheImageOfTheFrame) {
  const Outcome outcome = run("compile scenes/cube.json --size 80x60 -o " + path("cube.image"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const SceneImage image = compile(load_scene("scenes/cube.json", FrameSize{80, 60}), 80, 60);
  EXPECT_EQ(read(path("cube.image")), std::string(image.bytes.begin(), image.bytes.end()));
  EXPECT_NE(outcome.out.find("80x60"), std::string::npos) << outcome.out;
}

TEST_F(CommandLine, CompileRefusesInOneLineAndWritesNothing) {
  EXPECT_EQ(run("compile scenes/none.json -o " + path("a.image")).code, 2);
  EXPECT_EQ(run("compile scenes/cube.json").code, 2);
  EXPECT_EQ(run("compile scenes/cube.json -o scenes/cube.json").code, 2) << "the scene would be overwritten";
  EXPECT_EQ(run("compile scenes/cube.json -o " + path("no/folder/a.image")).code, 6);
  EXPECT_FALSE(fs::exists(path("a.image")));
}

}  // namespace
}  // namespace castray::tb
