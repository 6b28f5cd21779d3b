// SPDX-License-Identifier: Apache-2.0
// The program from outside: bad input ends with one line that names file, place and cause, with the
// documented exit code, and with no picture; good input with all that was asked for.
// Cores: l1c32t3p1m0 l3c32t3p2m128
#include <nlohmann/json.hpp>

#include "cli/summary.hpp"
#include "command_line.hpp"

namespace castray::tb {
namespace {

TEST_F(CommandLine, BadMeshes) {
  const std::string out = " --engine model -o " + path("out.png") + " --aov " + path("out.exr");
  const std::string corners = "1 3 0 1 2 ", points = "0 0 0 1 0 0 0 1 0 ";
  const auto refused = [&](const std::string& text, const std::string& cause) {
    const std::string mesh = file("bad.geo", text);
    expect_refused("render " + mesh + out, 2, {mesh, cause});
  };
  expect_refused("render " + path("none.geo") + out, 2, {path("none.geo"), "no such file"});
  refused("", "");
  refused(corners + "0 0 0 1", "");
  refused("1 2 0 1 " + points, "corner");
  refused("1 3 0 1 99999999999 " + points, "");
  refused(corners + "0 0 0 1 0 0 0 nan 0", "");
  refused(corners + "0 0 0 1 0 0 0 inf 0", "");
  refused(corners + "0 0 0 1e300 0 0 0 1 0", "");
  refused(corners + points + "1 2", "");
  refused("0 0 0 0", "");
}

TEST_F(CommandLine, BadScenes) {
  const std::string out = " --engine model -o " + path("out.png");
  const auto refused = [&](const std::string& text) {
    const std::string scene = file("bad.json", text);
    expect_refused("render " + scene + out, 2, {scene});
  };
  refused("{");
  refused("[]");
  refused("{}");
  refused(R"({"spheres": [{"centre": [0, 0, 0], "radius": -1}]})");
  refused(R"({"spheres": [{"centre": [0, 0, 0], "radius": 1}], "size": [0, 10]})");
  refused(R"({"spheres": [{"centre": [0, 0, 0], "radius": 1}], "camera": {"eye": [1, 1, 1], "look_at": [1, 1, 1]}})");
  refused(R"({"spheres": [{"centre": [0, 0, 0], "radius": 1}], "camera": {"eye": [1e40, 1, 1], "look_at": [0, 0, 0]}})");
}

TEST_F(CommandLine, BadOptions) {
  const std::string scene = "render scenes/cube.json --engine model -o " + path("out.png") + " ";
  for (const std::string size : {"+8x8", "8x+8", "0x10", "10x0", "5000x10", "10", "x", "10x", "-3x5", "10x10x10", "99999999999x1"})
    expect_refused(scene + "--size " + size, 2, {size});
  expect_refused("render scenes/cube.json --engine gpu", 2, {"engine", "gpu"});
  expect_refused("render scenes/cube.json --stalls sometimes", 2, {"stalls", "sometimes"});
  expect_refused("render scenes/cube.json --memory dram", 2, {"memory", "dram"});
  expect_refused("render scenes/cube.json --lanes 7", 2, {"7 lanes", "make"});
  for (const std::string lanes : {"three", "0", "9", "-1", "1.5", "99999999999"}) expect_refused("render scenes/cube.json --lanes " + lanes, 2, {"lanes", lanes});
  for (const std::string contexts : {"0", "65", "-1"}) expect_refused("render scenes/cube.json --contexts " + contexts, 2, {"contexts", contexts});
  for (const std::string kbytes : {"-1", "18446744073709551615", "99999999999", "1.5", "x"})
    expect_refused("render scenes/cube.json --l2 " + kbytes, 2, {"l2", kbytes, "range"});
  for (const std::string seed : {"-1", "18446744073709551616", "1e3", "x"})
    expect_refused("render scenes/cube.json --seed " + seed, 2, {"seed", seed});
  expect_refused("render", 2, {"scene"});
  expect_refused("polish scenes/cube.json", 2, {"polish"});
  expect_refused("", 2, {"subcommand"});
  expect_refused(scene + "--trace-window 1:2", 2, {"--trace"});
  expect_refused(scene + "--check", 2, {"--check"});
  const std::string rtl = "render scenes/cube.json -o " + path("out.png") + " --trace " + path("t.fst");
  expect_refused(rtl, 2, {"--trace", "--check"});
  expect_refused(rtl + " --engine model --trace-window 1:2", 2, {"--trace", "rtl"});
  for (const std::string window : {"1", "5:5", "9:3", "-1:5", "1:2:3", "1:+2", "a:b", "0:99999999999999999999999"})
    expect_refused(rtl + " --trace-window " + window, 2, {"--trace-window", window});
  expect_refused("ray scenes/cube.json 500 1 --size 16x16", 2, {"500"});
}

TEST_F(CommandLine, RendersChecksAndReports) {
  const Outcome outcome = run("render scenes/spheres.json --size 24x16 --lanes 3 --check --stalls uniform --seed 5 -o " + path("a.png") + " --aov " +
                              path("a.exr") + " --json " + path("a.json") + " --hits " + path("a.hits") + " --frame " + path("a.frame") +
                              " --save-scene " + path("scene.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const auto report = nlohmann::json::parse(read(path("a.json")));
  EXPECT_EQ(report["pixels"], 384);
  EXPECT_EQ(report["pixels_differ"], 0);
  EXPECT_EQ(report["hits_differ"], 0);
  EXPECT_EQ(report["lanes"], 3);
  EXPECT_EQ(report["stalls"], "uniform");
  EXPECT_EQ(report["seed"], 5);
  EXPECT_GT(report["cycles"], 1000);
  EXPECT_GT(report["cycles"], report["frame_alone"]["cycles"]) << "the hit buffer costs cycles";
  const auto with_commas = [](std::uint64_t cycles) { return cli::grouped(cycles); };
  for (const std::string& line : {"  cycles " + with_commas(report["cycles"]) + ", the hit buffer written as well\n",
                                  "  the frame alone: cycles " + with_commas(report["frame_alone"]["cycles"]) + "; 0 of 384 pixels differ",
                                  "waited to look up a node " + with_commas(report["node_waits"]) + ", a leaf " + with_commas(report["leaf_waits"]) +
                                      ", a test for its queue " + with_commas(report["test_waits"]) + "\n"})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << "not in:\n" << outcome.out;
  const std::string wrote = "wrote " + path("a.png") + "\nwrote " + path("a.exr") + "\nwrote " + path("a.frame") + "\nwrote " + path("a.hits") + "\nwrote " + path("a.json") + "\n";
  EXPECT_TRUE(outcome.out.ends_with(wrote)) << outcome.out;
  EXPECT_EQ(fs::file_size(path("a.hits")), 384u * 32);
  EXPECT_EQ(fs::file_size(path("a.frame")), 384u * 4);

  // The engines agree, and the saved scene is the scene.
  ASSERT_EQ(run("render " + path("scene.json") + " --engine model --size 24x16 -o " + path("b.png") + " --hits " + path("b.hits")).code, 0);
  EXPECT_EQ(read(path("a.hits")), read(path("b.hits")));
  EXPECT_EQ(run("compare " + path("a.png") + " " + path("b.png")).code, 0);
  ASSERT_EQ(run("render scenes/spheres.json --engine float64 --size 24x16 -o " + path("c.png")).code, 0);
  EXPECT_EQ(run("compare --tolerance 1 " + path("a.png") + " " + path("c.png")).code, 0);
  ASSERT_EQ(run("render scenes/spheres.json --engine float32 --size 16x24 -o " + path("d.png")).code, 0);
  EXPECT_EQ(run("compare " + path("a.png") + " " + path("d.png")).code, 1) << "other dimensions";
  EXPECT_EQ(run("compare " + path("a.png") + " " + path("none.png")).code, 2);
}

// Nothing else is said of a frame that is not checked.
TEST_F(CommandLine, AFrameAloneHasItsOwnCycles) {
  const Outcome outcome = run("render scenes/cube.json --size 16x16 -o " + path("a.png"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("hit buffer"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("frame alone"), std::string::npos) << outcome.out;
}

TEST_F(CommandLine, BoundsTheStepsOfARay) {
  const std::string rays = file("rays.csv", "ox,oy,oz,dx,dy,dz\n0.3,0.2,5,0,0,-1\n");
  for (const std::string& command : {"render scenes/cube.json --size 16x16 -o " + path("a.png"), "query scenes/cube.json " + rays + " -o " + path("a.csv")}) {
    for (const std::string engine : {"rtl", "model"})
      expect_refused(command + " --steps 1 --engine " + engine, 3, {"error 14", "more nodes than the job allows"});
    for (const std::string steps : {"-1", "16777216", "few"}) expect_refused(command + " --steps " + steps, 2, {"steps", steps});
    EXPECT_EQ(run(command + " --steps 1000 --check").code, 0);
    EXPECT_EQ(run(command + " --steps 1 --mode brute").code, 0) << "no nodes, no limit to them";
    for (const char* answer : {"a.png", "a.csv"}) fs::remove(path(answer));
  }
  expect_refused("ray scenes/cube.json 8 8 --size 16x16 --steps 1", 3, {"more nodes than the job allows"});
}

TEST_F(CommandLine, ShowsARay) {
  const Outcome outcome = run("ray scenes/spheres.json 12 8 --size 24x16 --trace " + path("ray.fst") + kWithWaves);
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const char* stage : {"tile_bounds", "frontier", "tile_node", "tile_start", "ray_gen", "ray_setup", "goes to", "meets", "prim_tests", "ray_prim",
                            "hit_unit", "lane", "shade", "hit record", "float64", "0 values differ"})
    EXPECT_NE(outcome.out.find(stage), std::string::npos) << stage;
  for (const std::string work : {"\n  tests ", "\n  nodes "}) {
    const std::size_t at = outcome.out.find(work, outcome.out.find("hit record"));
    ASSERT_NE(at, std::string::npos) << work;
    EXPECT_GT(std::stoi(outcome.out.substr(at + work.size())), 0) << work;
  }
  EXPECT_GT(fs::file_size(path("ray.fst")), 1000u);
}

TEST_F(CommandLine, ARayThatMissesDiffersInNothing) {
  const Outcome outcome = run("ray scenes/cube.json 0 0 --size 24x16");
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const char* words : {"float64: primitive -1", "0 values differ"}) EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
}

TEST_F(CommandLine, ACoreWithoutWaveformsIsNamedBeforeTheFrame) {
  for (const std::string& command : {"render scenes/cube.json --check -o " + path("a.png"), std::string("ray scenes/cube.json 1 1 --size 8x8")})
    expect_refused(command + " --trace " + path("a.fst"), 2, {"without waveforms", "make build/cores/l3c32t3p2m128w.so"});
}

// A mesh alone leaves much to defaults: they are not printed before a refusal.
TEST_F(CommandLine, ACoreThatWasNotBuiltIsOneLine) {
  const std::string rays = file("rays.csv", "ox,oy,oz,dx,dy,dz\n0,0,5,0,0,-1\n"), five = " --lanes 5 --contexts 7";
  const std::string words = "make build/cores/l5c7t3p2m128.so";
  expect_refused("render scenes/cube.geo -o " + path("a.png") + " --save-scene " + path("a.json") + five, 2, {words});
  expect_refused("ray scenes/cube.geo 1 1" + five, 2, {words});
  expect_refused("query scenes/cube.geo " + rays + five, 2, {words});
}

TEST_F(CommandLine, APictureThatIsCutOffIsOneLine) {
  ASSERT_EQ(run("render scenes/spheres.json --engine model --size 24x16 -o " + path("a.png")).code, 0);
  const std::string bytes = read(path("a.png"));
  for (const std::size_t size : {bytes.size() / 2, std::size_t{20}, std::size_t{0}})
    expect_refused("compare " + path("a.png") + " " + file("b.png", bytes.substr(0, size)), 2, {"b.png"});
}

TEST_F(CommandLine, TracesAWindow) {
  const std::string command = "render scenes/cube.json --size 8x8 -o " + path("a.png") + " --trace " + path("a.fst") + kWithWaves;
  ASSERT_EQ(run(command + " --trace-window 100:400").code, 0);
  const auto small = fs::file_size(path("a.fst"));
  EXPECT_GT(small, 1000u);
  ASSERT_EQ(run(command + " --trace-window 100:1500").code, 0);
  EXPECT_GT(fs::file_size(path("a.fst")), small);
}

TEST_F(CommandLine, MeshesNeedNoSceneFile) {
  const Outcome outcome = run("render scenes/cube.geo --engine model --size 24x16 -o " + path("a.png"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("default"), std::string::npos) << "the defaults are printed";
  EXPECT_EQ(run("info scenes/cube.geo").code, 0);
  EXPECT_EQ(run("--version").code, 0);
  EXPECT_EQ(run("render --help").code, 0);
}

}  // namespace
}  // namespace castray::tb
