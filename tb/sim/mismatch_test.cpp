// SPDX-License-Identifier: Apache-2.0
// A core that errs: castray render --check names the pixel, both values and the command that replays
// the ray, traces it where asked to, and ends with its exit code; castray ray shows the value too.
// Cores: l1c32t3p1m0 l3c32t3p2m128
#include <nlohmann/json.hpp>
#include <set>

#include "cli/arguments.hpp"
#include "command_line.hpp"
#include "comparison.hpp"
#include "mem/image.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

constexpr int kWidth = 16, kHeight = 12;

// The simulated core, but for what `fault` does to its answers.
template <class Fault> sim::RunRtl erring(Fault fault) {
  return [fault](const SceneImage& image, const sim::RtlOptions& device, const sim::RenderOptions& options, const sim::Progress& progress) {
    sim::RtlRun run = sim::run_rtl(image, device, options, progress);
    fault(run.rendering);
    return run;
  };
}
// One bit of one pixel, or of the primitive in its hit record.
sim::RunRtl pixel_error(int x, int y) {
  return erring([=](sim::Rendering& r) { r.pixels[r.index(x, y)] ^= 0x40; });
}
sim::RunRtl hit_error(int x, int y) {
  return erring([=](sim::Rendering& r) {
    if (!r.hits.empty()) r.hits[r.index(x, y) * HitBytes + 12] ^= 1;
  });
}

class Mismatch : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    fs::copy("scenes/cube.geo", path("cube.geo"));
    fs::copy("scenes/cube.json", scene_);
    image_ = compile(load_scene(scene_), kWidth, kHeight);
    expected_ = sim::run_model(image_);
    before_ = files();
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename());
    return names;
  }
  // The files that came since the set-up.
  std::set<std::string> made() const {
    std::set<std::string> names;
    for (const std::string& name : files())
      if (!before_.count(name)) names.insert(name);
    return names;
  }
  Outcome render(const sim::RunRtl& core, const std::string& options) const {
    return run("render " + cli::shell_word(scene_) + " --size 16x12 --check -o " + path("a.png") + " " + options, core);
  }
  // Does the output have these lines, one behind the other?
  static void expect_lines(const std::string& out, const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    EXPECT_NE(out.find(all), std::string::npos) << all << "not in:\n" << out;
  }
  // The lines about one pixel, whose values in the RTL are those of `rtl`.
  void expect_explained(const std::string& out, const sim::Rendering& rtl, int x, int y, const std::string& options = "") const {
    const std::string place = std::to_string(x) + " " + std::to_string(y);
    const std::size_t i = rtl.index(x, y);
    expect_lines(out, {"  (" + std::to_string(x) + ", " + std::to_string(y) + ")", "    rtl    " + sim::text_of(rtl, i),
                       "    model  " + sim::text_of(expected_, i),
                       "    castray ray " + cli::shell_word(scene_) + " " + place + " --size 16x12" + options});
  }
  // The command that is printed for a pixel, without the name of the program.
  static std::string replay(const std::string& out) {
    const std::size_t at = out.find("    castray ray ");
    if (at == std::string::npos) return "";
    return out.substr(at + 12, out.find('\n', at) - at - 12);
  }

  const std::string scene_ = path("a cube.json");
  SceneImage image_;
  sim::Rendering expected_;
  std::set<std::string> before_;
};

TEST_F(Mismatch, NamesThePixelAndBothValues) {
  const Outcome outcome = render(pixel_error(9, 6), "--json " + path("a.json"));
  EXPECT_EQ(outcome.code, cli::kMismatch) << outcome.err;
  expect_lines(outcome.out, {"  against the model: 1 of 192 pixels and 0 of 192 hit records differ"});
  sim::Rendering rtl = expected_;
  rtl.pixels[rtl.index(9, 6)] ^= 0x40;
  expect_explained(outcome.out, rtl, 9, 6);
  const auto report = nlohmann::json::parse(read(path("a.json")));
  EXPECT_EQ(report["pixels_differ"], 1);
  EXPECT_EQ(report["hits_differ"], 0);
}

TEST_F(Mismatch, NamesAHitRecordWhosePixelIsRight) {
  const Outcome outcome = render(hit_error(0, 11), "");
  EXPECT_EQ(outcome.code, cli::kMismatch) << outcome.err;
  expect_lines(outcome.out, {"  against the model: 0 of 192 pixels and 1 of 192 hit records differ"});
  sim::Rendering rtl = expected_;
  rtl.hits[rtl.index(0, 11) * HitBytes + 12] ^= 1;
  expect_explained(outcome.out, rtl, 0, 11);
}

TEST_F(Mismatch, LeavesTheWholePictureAndNothingElse) {
  ASSERT_EQ(render(pixel_error(3, 2), "").code, cli::kMismatch);
  EXPECT_EQ(made(), std::set<std::string>{"a.png"});
  ASSERT_EQ(run("render " + cli::shell_word(scene_) + " --engine model --size 16x12 -o " + path("b.png")).code, 0);
  const Outcome compared = run("compare " + path("a.png") + " " + path("b.png"));
  EXPECT_EQ(compared.out, "1 of 192 pixels differ by more than 0 of 255, the worst by 64\nthe first at (3, 2)\n");
}

TEST_F(Mismatch, TracesTheFirstPixelThatDiffers) {
  const sim::RunRtl core = erring([](sim::Rendering& r) {
    for (const int x : {7, 5}) r.pixels[r.index(x, 4)] ^= 1;
  });
  const Outcome outcome = render(core, "--trace " + path("a.fst") + kWithWaves);
  EXPECT_EQ(outcome.code, cli::kMismatch) << outcome.err;
  expect_lines(outcome.out, {"wrote " + path("a.fst") + ", the waveforms of pixel (5, 4)"});
  EXPECT_EQ(made(), (std::set<std::string>{"a.png", "a.fst"}));
  const auto size = fs::file_size(path("a.fst"));
  ASSERT_EQ(run("ray " + cli::shell_word(scene_) + " 5 4 --size 16x12 --trace " + path("ray.fst") + kWithWaves).code, 0);
  EXPECT_EQ(size, fs::file_size(path("ray.fst"))) << "not the waveforms of that pixel alone";
}

TEST_F(Mismatch, TracesNothingWhereNothingDiffers) {
  EXPECT_EQ(render(sim::run_rtl, "--trace " + path("a.fst") + kWithWaves).code, cli::kOk);
  EXPECT_EQ(made(), std::set<std::string>{"a.png"});
}

TEST_F(Mismatch, NamesTheFirstFewOfMany) {
  const sim::RunRtl core = erring([](sim::Rendering& r) {
    for (std::uint32_t& pixel : r.pixels) pixel ^= 0x100;
  });
  const Outcome outcome = render(core, "");
  EXPECT_EQ(outcome.code, cli::kMismatch);
  expect_lines(outcome.out, {"  against the model: 192 of 192 pixels and 0 of 192 hit records differ"});
  std::size_t commands = 0;
  for (std::size_t at = 0; (at = outcome.out.find("castray ray ", at)) != std::string::npos; ++at) ++commands;
  EXPECT_EQ(commands, 8u);
}

TEST_F(Mismatch, CountersAreComparedToo) {
  for (const auto counter : {CntTests, CntRays, CntHits, CntCandidates, CntNodes, CntTileNodes, CntEmptyTiles}) {
    std::uint64_t right = 0;
    const Outcome outcome = render(erring([&](sim::Rendering& r) {
                                     if (!r.hits.empty()) right = r.counters[static_cast<std::size_t>(counter)]++;
                                   }), "--json " + path("a.json"));
    EXPECT_EQ(outcome.code, cli::kMismatch);
    EXPECT_NE(outcome.out.find(": " + std::to_string(right + 1) + ", in the model " + std::to_string(right) + "\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(nlohmann::json::parse(read(path("a.json")))["counters_differ"], 1);
  }
}

// What is seen only where no hit records are written: empty tiles are filled there.
TEST_F(Mismatch, TheFrameAloneIsComparedToo) {
  const auto alone = [&](auto&& fault) {
    return render(erring([=](sim::Rendering& r) {
                    if (r.hits.empty()) fault(r);
                  }), "");
  };
  const Outcome pixel = alone([](sim::Rendering& r) { r.pixels[r.index(2, 1)] ^= 1; });
  EXPECT_EQ(pixel.code, cli::kMismatch);
  EXPECT_NE(pixel.out.find("; 1 of 192 pixels differ from the model\n  (2, 1)\n"), std::string::npos) << pixel.out;
  const Outcome counter = alone([](sim::Rendering& r) { ++r.counters[CntEmptyTiles]; });
  EXPECT_EQ(counter.code, cli::kMismatch);
  EXPECT_NE(counter.out.find("\n  counter empty_tiles: "), std::string::npos) << counter.out;
  const Outcome error = alone([](sim::Rendering& r) { r.error = ErrReadBus; });
  EXPECT_EQ(error.code, cli::kDeviceError);
}

// The command as it is printed: the options of the core are in it, and a blank in a name.
TEST_F(Mismatch, TheReplayRuns) {
  const std::string options = " --memory hp --stalls uniform --reorder --seed 5";
  const Outcome outcome = render(pixel_error(9, 6), options);
  sim::Rendering rtl = expected_;
  rtl.pixels[rtl.index(9, 6)] ^= 0x40;
  expect_explained(outcome.out, rtl, 9, 6, options);
  const std::string command = replay(outcome.out);
  const Outcome right = run(command);
  EXPECT_EQ(right.code, cli::kOk) << command << right.err;
  EXPECT_NE(right.out.find("pixel (9, 6) of 16x12"), std::string::npos) << right.out;
  EXPECT_NE(right.out.find("stalls uniform, seed 5"), std::string::npos) << right.out;
  EXPECT_NE(right.out.find("\n0 values differ"), std::string::npos) << right.out;
}

TEST_F(Mismatch, TheReplayShowsTheValueThatDiffers) {
  for (const auto& [core, field] : {std::pair{pixel_error(9, 6), "  colour "}, {hit_error(9, 6), "  prim "}}) {
    const Outcome outcome = run(replay(render(core, "").out), core);
    EXPECT_EQ(outcome.code, cli::kMismatch) << outcome.err;
    EXPECT_NE(outcome.out.find("\n1 values differ"), std::string::npos) << outcome.out;
    const std::size_t mark = outcome.out.find("<-- differs");
    ASSERT_NE(mark, std::string::npos);
    const std::string line = outcome.out.substr(outcome.out.rfind('\n', mark) + 1);
    EXPECT_TRUE(line.starts_with(field)) << line;
  }
}

// The mode is that of the frame: a tile starts as it did there.
TEST_F(Mismatch, TheReplayIsInTheModeOfTheFrame) {
  for (const std::string mode : {"bvh", "bvh_root", "brute"}) {
    const std::string command = replay(render(pixel_error(9, 6), "--mode " + mode).out);
    EXPECT_EQ(command.find("--mode " + mode) != std::string::npos, mode != "bvh") << "the default need not be said: " << command;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, cli::kOk) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find(", mode " + mode + ": "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("tile_bounds") != std::string::npos, mode == "bvh");
    EXPECT_NE(outcome.out.find(mode == "bvh" ? " 8x8 at 8, 0" : " 1x1 at 9, 6"), std::string::npos) << "the whole tile: " << outcome.out;
    EXPECT_EQ(outcome.out.find("node_visits") != std::string::npos, mode != "brute");
    EXPECT_NE(outcome.out.find("\n0 values differ"), std::string::npos) << outcome.out;
  }
}

// Each ray of two tiles, whose contexts are used again and again: what is shown is its own.
TEST_F(Mismatch, EveryRayOfATileIsFound) {
  for (int x = 1; x < kWidth; x += 2)
    for (const std::string core : {"", kWithWaves}) {
      const Outcome outcome = run("ray " + cli::shell_word(scene_) + " " + std::to_string(x) + " " + std::to_string(x * 5 % kHeight) + " --size 16x12" + core);
      EXPECT_EQ(outcome.code, cli::kOk) << x << outcome.out;
    }
}

// A core that reads another root than the model: the start of the tile is where they part.
TEST_F(Mismatch, TheReplayShowsTheStartOfATile) {
  const sim::RunRtl core = [](SceneImage image, const sim::RtlOptions& device, const sim::RenderOptions& options, const sim::Progress& progress) {
    std::uint8_t* const bytes = image.bytes.data() + image.header.nodes.offset;
    node_t root = load_record<node_t>(bytes);
    for (child_box_t* box : {&root.box0, &root.box1, &root.box2, &root.box3}) box->x0 = box->x1, box->y0 = box->y1, box->z0 = box->z1;
    store_record(bytes, root);
    return sim::run_rtl(image, device, options, progress);
  };
  const std::string command = "ray " + cli::shell_word(scene_) + " 9 6 --size 16x12";
  const Outcome outcome = run(command, core);
  EXPECT_EQ(outcome.code, cli::kMismatch) << outcome.err;
  const std::size_t first = outcome.out.find("<-- differs"), start = outcome.out.find("(frontier)"), ray = outcome.out.find("(ray_gen)");
  EXPECT_LT(start, first) << outcome.out;
  EXPECT_LT(first, ray) << outcome.out;

  // From the root there is no start: the node's children differ.
  const Outcome root = run(command + " --mode bvh_root", core);
  EXPECT_EQ(root.code, cli::kMismatch) << root.err;
  EXPECT_LT(root.out.find("(step, node_visits)"), root.out.find("<-- differs")) << root.out;
}

TEST_F(Mismatch, AShellReadsItsWords) {
  for (const std::string word : {"plain/name-1.json", "a blank", "it's", "", "$HOME", "a\"b\\c", "tab\there"}) {
    FILE* shell = popen(("printf %s " + cli::shell_word(word)).c_str(), "r");
    char text[64] = "";
    const std::size_t length = std::fread(text, 1, sizeof text, shell);
    EXPECT_EQ(pclose(shell), 0);
    EXPECT_EQ(std::string(text, length), word);
  }
}

}  // namespace
}  // namespace castray::tb
