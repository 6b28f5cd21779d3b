// SPDX-License-Identifier: Apache-2.0
// castray compile from outside: the bytes that the core is given, as a file.
#include <thread>

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

TEST_F(CommandLine, CompileToStandardOutputIsTheImageAlone) {
  ASSERT_EQ(run("compile scenes/cube.json --size 80x60 -o " + path("cube.image")).code, 0);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  std::string got;
  std::thread reader([&] {
    char part[4096];
    for (ssize_t count; (count = ::read(ends[0], part, sizeof part)) > 0;) got.append(part, static_cast<std::size_t>(count));
  });
  std::fflush(stdout);
  const int kept = dup(STDOUT_FILENO);
  dup2(ends[1], STDOUT_FILENO);
  close(ends[1]);
  testing::internal::CaptureStderr();
  const int code = execute("compile scenes/cube.json --size 80x60 -o /dev/stdout");
  const std::string err = testing::internal::GetCapturedStderr();
  std::fflush(stdout);
  dup2(kept, STDOUT_FILENO);
  close(kept);
  reader.join();
  close(ends[0]);
  EXPECT_EQ(code, 0);
  EXPECT_EQ(got, read(path("cube.image")));
  EXPECT_EQ(err.substr(0, 18), "wrote /dev/stdout:");
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
