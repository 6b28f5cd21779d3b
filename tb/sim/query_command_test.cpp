// SPDX-License-Identifier: Apache-2.0
// castray query from outside: answers in every form and of every engine, and what is refused.
// Cores: l1c32t3p1m0 l3c32t3p2m128
#include <nlohmann/json.hpp>
#include <random>

#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "mem/ray_request.hpp"
#include "query_command.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

const std::string kTeapot = "query scenes/teapot.json scenes/rays.csv ";

// The example of the page, as it stands there.
TEST_F(QueryCommand, ThePagesExample) {
  const std::string page = read("docs/query.md"), prompt = "\n$ build/castray ";
  const std::size_t at = page.find(prompt);
  ASSERT_NE(at, std::string::npos);
  const std::size_t command = at + prompt.size(), output = page.find('\n', command) + 1, end = page.find("```", output);
  const Outcome outcome = run(page.substr(command, output - 1 - command));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, page.substr(output, end - output));
}

TEST_F(QueryCommand, EnginesAgree) {
  const auto model = table(run(kTeapot + "--engine model").out);
  ASSERT_EQ(model.size(), 8u);
  for (const auto& [engine, rounding] : {std::pair{"float64", 1e-6}, {"float32", 1e-4}}) {
    const auto reference = table(run(kTeapot + "--engine " + engine).out);
    ASSERT_EQ(reference.size(), model.size());
    for (std::size_t i = 0; i < model.size(); ++i) {
      EXPECT_EQ(reference[i][0], model[i][0]) << i;
      EXPECT_EQ(reference[i][1], model[i][1]) << i;
      EXPECT_EQ(reference[i][3], "") << "t is the record's";
      for (const std::size_t column : {2, 4, 5})
        if (!model[i][column].empty()) EXPECT_NEAR(std::stod(reference[i][column]), std::stod(model[i][column]), 10 * rounding) << i << " " << column;
        else EXPECT_EQ(reference[i][column], "") << i << " " << column;
    }
  }
  EXPECT_EQ(run(kTeapot + "--engine model --mode brute").out, run(kTeapot + "--engine model").out);
}

TEST_F(QueryCommand, FilesAndStreamsGiveTheSameBytes) {
  const Outcome direct = run(kTeapot + "--engine model");
  EXPECT_EQ(direct.code, 0) << direct.err;
  EXPECT_NE(direct.err.find("rays 8, hits 6"), std::string::npos) << "figures go to standard error: " << direct.err;
  const Outcome filed = run(kTeapot + "--engine model -o " + path("a.csv"));
  EXPECT_EQ(read(path("a.csv")), direct.out);
  EXPECT_NE(filed.out.find("rays 8, hits 6"), std::string::npos) << filed.out;
  EXPECT_EQ(filed.err, "");
  EXPECT_EQ(with_input("scenes/rays.csv", "query scenes/teapot.json - --engine model").out, direct.out);
}

// The answer's distance and primitive as the next ray's tmin and ignore.
TEST_F(QueryCommand, AnAnswerIsTheNextRaysLimit) {
  const std::string start = kColumns.substr(0, kColumns.size() - 1) + ",tmin,ignore\n", ray = "0.3,0.2,5,0,0,-1,";
  const auto first = table(run(kCube + file("a.csv", start + ray + ",\n") + " --engine model").out).at(0);
  ASSERT_EQ(first[0], "1");
  const auto behind = table(run(kCube + file("b.csv", start + ray + first[2] + ",\n" + ray + "," + first[1] + "\n") + " --engine model").out);
  for (const auto& row : behind) {
    EXPECT_EQ(row[0], "1");
    EXPECT_NE(row[1], first[1]);
    EXPECT_NEAR(std::stod(row[2]), std::stod(first[2]) + 2, 1e-6) << "the cube's far side";
  }
}

// Limits, culling, ignored primitives and any hit mixed, for scenes/spheres.json.
std::string random_rays(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-3, 3), reach(0, 6);
  const auto one_in = [&](unsigned n) { return random() % n == 0; };
  std::ostringstream text;
  text << "any,tmax,ox,oy,oz,ignore,dx,dy,dz,cull,tmin\n";
  for (std::size_t i = 0; i < count; ++i) {
    const double tmin = one_in(3) ? reach(random) : 0;
    text << one_in(4) << ',';
    if (one_in(3)) text << tmin + reach(random);
    for (int k = 0; k < 3; ++k) text << ',' << place(random);
    text << ',';
    if (one_in(2)) text << random() % 24;
    for (int k = 0; k < 3; ++k) text << ',' << place(random);
    text << ',' << one_in(3) << ',' << tmin << '\n';
  }
  return text.str();
}

TEST_F(QueryCommand, RandomRaysAgreeWithFloat64) {
  const std::size_t count = 3000;
  const std::string ask = "query scenes/spheres.json " + file("rays.csv", random_rays(count, 7)) + " --engine ";
  const auto model = table(run(ask + "model").out), brute = table(run(ask + "model --mode brute").out), reference = table(run(ask + "float64").out);
  ASSERT_EQ(model.size(), count);
  ASSERT_EQ(reference.size(), count);
  EXPECT_TRUE(model == brute);
  std::size_t hits = 0, yes = 0, ties = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(model[i][0], reference[i][0]) << i;
    if (model[i][2].empty()) {
      yes += model[i][0] == "1";
      continue;
    }
    ++hits;
    const bool same = model[i][1] == reference[i][1];
    ties += !same;  // the cube stands on the ground
    EXPECT_NEAR(std::stod(model[i][2]), std::stod(reference[i][2]), same ? 1e-4 : 1e-5) << i;
  }
  EXPECT_GT(hits, count / 5);
  EXPECT_GT(yes, count / 20);
  EXPECT_LT(ties, hits / 50);
}

TEST_F(QueryCommand, TheSimulatedCoreAgreesWithTheModel) {
  const std::string ask = "query scenes/spheres.json " + file("rays.csv", random_rays(500, 8)) + " ";
  const std::string expected = run(ask + "--engine model").out;
  for (const std::string core : {"--lanes 1 --ports 1 --l2 0 --stalls uniform --seed 3", "--lanes 3 --memory hp", "--lanes 3 --mode brute"}) {
    const Outcome outcome = run(ask + core + " --check --json " + path("a.json"));
    ASSERT_EQ(outcome.code, 0) << core << outcome.err;
    EXPECT_EQ(outcome.out, expected) << core;
    EXPECT_NE(outcome.err.find("against the model: 0 of 500 hit records differ"), std::string::npos) << outcome.err;
    const auto report = nlohmann::json::parse(read(path("a.json")));
    EXPECT_EQ(report["hits_differ"], 0);
    EXPECT_GT(report["cycles"], 500);
    EXPECT_EQ(report["rays"], 500);
  }
}

TEST_F(QueryCommand, WaveformsOfOneRay) {
  const std::string ask = kTeapot + "-o " + path("a.csv") + " --only 2 --check";
  const Outcome outcome = run(ask + " --trace " + path("a.fst") + kWithWaves);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(fs::file_size(path("a.fst")), 1000u);
  EXPECT_EQ(table(read(path("a.csv"))), table(run(kTeapot + "--engine model --only 2").out));
}

TEST_F(QueryCommand, OneRayOnTheGridOfAll) {
  const auto all = table(run(kTeapot + "--engine model").out);
  for (const std::size_t i : {0, 4, 7})
    EXPECT_EQ(table(run(kTeapot + "--engine model --only " + std::to_string(i)).out), (std::vector<std::vector<std::string>>{all[i]}));
  EXPECT_EQ(table(run(kTeapot + "--engine float64 --only 2").out).size(), 1u);
  expect_refused(kTeapot + "--engine model --only 8", 2, {"--only 8", "8 rays"});
  expect_refused(kTeapot + "--engine model --only -1", 2, {"--only"});
}

TEST_F(QueryCommand, AFramesRaysAsRecordsGiveItsHits) {
  const SceneImage image = compile(load_scene("scenes/spheres.json", FrameSize{24, 16}), 24, 16);
  const camera_t camera = frame_setup(image.frame);
  std::vector<ray_record_t> rays;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x) rays.push_back(ray_record(camera.eye, ray_gen(camera, x, y)));
  const std::vector<std::uint8_t> bytes = sim::bytes_of(rays);
  const std::string name = file("rays.bin", std::string(bytes.begin(), bytes.end()));
  const std::string scene = "scenes/spheres.json --size 24x16 --engine model ";
  ASSERT_EQ(run("render " + scene + "-o " + path("a.png") + " --hits " + path("a.hits")).code, 0);
  const Outcome filed = run("query " + scene + name + " --raw -o " + path("b.hits"));
  ASSERT_EQ(filed.code, 0) << filed.err;
  EXPECT_EQ(read(path("b.hits")), read(path("a.hits")));
  EXPECT_EQ(with_input(name, "query " + scene + "- --raw").out, read(path("a.hits")));
}

TEST_F(QueryCommand, Reports) {
  const Outcome outcome = run(kTeapot + "--engine model --mode bvh -o " + path("a.csv") + " --json " + path("a.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.ends_with("wrote " + path("a.csv") + "\nwrote " + path("a.json") + "\n")) << outcome.out;
  const auto report = nlohmann::json::parse(read(path("a.json")));
  EXPECT_EQ(report["scene"], "teapot");
  EXPECT_EQ(report["engine"], "model");
  EXPECT_EQ(report["mode"], "bvh_root") << "a ray of a list has no tile";
  EXPECT_EQ(report["rays"], 8);
  EXPECT_EQ(report["hits"], 6);
  EXPECT_EQ(report["grid_power"], -22);
  EXPECT_GT(report["nodes"], 8);
  EXPECT_GE(report["seconds"], 0);
  ASSERT_EQ(run(kTeapot + "--engine float64 -o " + path("b.csv") + " --json " + path("b.json")).code, 0);
  EXPECT_EQ(nlohmann::json::parse(read(path("b.json")))["hits"], 6);
}

TEST_F(QueryCommand, BadRays) {
  const std::string out = " --engine model -o " + path("out.csv") + " --json " + path("out.json");
  const auto refused = [&](const std::string& text, const std::string& cause) {
    const std::string name = file("bad.csv", text);
    expect_refused(kCube + name + out, 2, {name + ":" + cause});
  };
  refused("", "1: empty");
  refused(kColumns, "1: no rays");
  refused(kColumns + "0,0,5,0,0,-1\n0,0,5,0,0\n", "3: 5 fields");
  refused(kColumns + "0,0,5,0,0,nan\n", "2: dz: 'nan'");
  refused(kColumns + "0,0,5,0,0,0\n", "2: the direction is zero");
  refused(kColumns + "0,0,1e20,0,0,1\n", "2: oz: 1e+20 is outside the number range");
  refused(kColumns + "0,0,5,0,0,1\n0,1e15,0,0,0,1\n0,0,6,0,0,1\n", "3: the origin lies too far from the scene");
  refused("ox,oy,oz,dx,dy,dz,ignore\n0,0,5,0,0,1,12\n", "2: ignore: '12'");
  refused("ox,oy,oz,dx,dy,dz,tmin,tmax\n0,0,5,0,0,1,2,1\n", "2: empty range");
  expect_refused(kCube + path("none.csv") + out, 2, {path("none.csv"), "no such file"});
  expect_refused(kCube + path("") + out, 2, {path(""), "folder"});
  const Outcome piped = with_input(file("bad.csv", kColumns + "1\n"), kCube + "-" + out);
  EXPECT_EQ(piped.code, 2);
  EXPECT_EQ(piped.err, "castray: standard input:2: 1 field, the first line names 6 columns\n");
}

TEST_F(QueryCommand, BadRecords) {
  const std::string out = " --raw --engine model -o " + path("out.bin");
  expect_refused(kCube + file("bad.bin", "") + out, 2, {path("bad.bin") + ": empty"});
  for (const std::size_t size : {1, 63, 65, 100})
    expect_refused(kCube + file("bad.bin", std::string(size, '\0')) + out, 2, {path("bad.bin"), std::to_string(size) + " byte", "64"});
  std::string flags(128, '\0');
  flags[64 + 12] = 4;
  expect_refused(kCube + file("bad.bin", flags) + out, 2, {path("bad.bin") + ": record 1: flags of 4"});
  // Zero directions and origins outside the grid are misses.
  std::string misses(128, '\0');
  misses[64 + 3] = '\x40';
  const Outcome outcome = run(kCube + file("misses.bin", misses) + out);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("rays 2, hits 0"), std::string::npos) << outcome.out;
}

// More than the rays of a list could take is not read: of a file with a hole, and of a device without end.
TEST_F(QueryCommand, MoreThanAListIsNotRead) {
  const std::string records = std::to_string(std::uint64_t{MaxRays} * RayBytes);
  file("hole", "");
  fs::resize_file(path("hole"), std::uint64_t{5} << 30);
  expect_refused(kCube + path("hole") + " --engine model", 2, {"hole", "more than 4294967296 bytes"});
  expect_refused(kCube + path("hole") + " --raw --engine model", 2, {"hole", "more than " + records + " bytes"});
  const Outcome outcome = with_input("/dev/zero", kCube + "- --raw --engine model");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "castray: standard input: read: more than " + records + " bytes, the most that are read\n");
}

TEST_F(QueryCommand, BadOptions) {
  const std::string rays = file("rays.csv", kColumns + "0,0,5,0,0,-1\n");
  expect_refused(kCube + rays + " --engine gpu", 2, {"engine", "gpu"});
  expect_refused(kCube + rays + " --engine model --check", 2, {"--check"});
  expect_refused(kCube + rays + " --engine float64 --raw", 2, {"--raw"});
  expect_refused(kCube + rays + " --trace " + path("t.fst"), 2, {"--trace", "--only"});
  expect_refused(kCube + rays + " --engine model --only 0 --trace " + path("t.fst"), 2, {"--trace", "rtl"});
  expect_refused("query scenes/cube.json", 2, {"rays"});
  expect_refused("query scenes/none.json " + rays, 2, {"scenes/none.json", "no such file"});
  expect_refused(kCube + rays + " --engine model -o " + rays, 2, {"--output", "rays"});
  expect_refused(kCube + rays + " --engine model -o " + path("a") + " --json " + path("a"), 2, {"--json", "--output"});
  expect_refused(kCube + rays + " --engine model -o scenes/cube.json", 2, {"--output", "scene"});
  expect_refused(kCube + rays + " --engine model -o " + path("none/a.csv"), 6, {path("none/a.csv")});
  expect_refused(kCube + rays + " --engine model --json " + path("none/a.json"), 6, {path("none/a.json")});
}

TEST_F(QueryCommand, WhatStoodUnderTheNameStaysWhereTheRaysAreBad) {
  const std::string out = file("out.csv", "before\n");
  expect_refused(kCube + file("bad.csv", kColumns + "x\n") + " --engine model -o " + out, 2, {"bad.csv:2"});
  EXPECT_EQ(read(out), "before\n");
}

TEST_F(QueryCommand, StandardOutputIsFull) { expect_needs_output(kTeapot + "--engine model"); }

}  // namespace
}  // namespace castray::tb
