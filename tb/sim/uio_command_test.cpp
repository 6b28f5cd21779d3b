// SPDX-License-Identifier: Apache-2.0
// castray render and query with --engine uio: the Verilated core in place of the mapped registers gives the model's pixels
// and hits; without a core, or with another one, one line says so.
// Cores: l1c32t3p1m0
#include <nlohmann/json.hpp>
#include <sstream>

#include "command_line.hpp"
#include "simulated_board.hpp"

namespace castray::tb {
namespace {

class UioCommand : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    kernel_.emplace(folder_ / "kernel");
    core_ = std::make_shared<SimulatedCore>(*kernel_);
  }
  // On the Verilated core.
  Outcome on_core(const std::string& arguments) const {
    return run(arguments + " --engine uio", sim::run_rtl, sim::query_rtl, [this](sim::BoardOptions options) {
      options.roots = kernel_->roots;
      return open_simulated(core_, options);
    });
  }
  // On the kernel's files as they are: nothing stands behind the registers.
  Outcome on_files(const std::string& arguments) const {
    return run(arguments + " --engine uio", sim::run_rtl, sim::query_rtl, [this](sim::BoardOptions options) {
      options.roots = kernel_->roots;
      return sim::open_board(options);
    });
  }
  // One line, but for a progress bar's.
  void expect_one_line(const Outcome& outcome, int code, const std::vector<std::string>& words) const {
    EXPECT_EQ(outcome.code, code);
    std::istringstream lines(outcome.err);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) count += !line.starts_with("rendering: ");
    EXPECT_EQ(count, 1u) << outcome.err;
    EXPECT_TRUE(says(outcome.err, words));
    EXPECT_FALSE(fs::exists(path("a.png")));
  }
  void set_register(std::int64_t offset, std::int64_t value) const {
    std::fstream file(kernel_->roots.dev / "uio0", std::ios::binary | std::ios::in | std::ios::out);
    const auto word = static_cast<std::uint32_t>(value);
    file.seekp(offset).write(reinterpret_cast<const char*>(&word), sizeof word);
  }

  std::string render_ = "render scenes/cube.json --size 32x24 -o " + path("a.png");
  std::optional<KernelFiles> kernel_;
  std::shared_ptr<SimulatedCore> core_;
};

TEST_F(UioCommand, RendersWhatTheModelDoes) {
  const Outcome outcome =
      on_core(render_ + " --check --json " + path("a.json") + " --frame " + path("a.frame") + " --hits " + path("a.hits"));
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  EXPECT_TRUE(says(outcome.out,
                   {"simulated core: lanes 1", "against the model: 0 of 768 pixels and 0 of 768 hit records differ", "cycles"}));
  const auto report = nlohmann::json::parse(read(path("a.json")));
  EXPECT_EQ(report["engine"], "uio");
  EXPECT_EQ(report["pixels_differ"], 0);
  EXPECT_GT(report["cycles"], 500);
  EXPECT_EQ(core_->rtl.violations(), 0u);
  ASSERT_EQ(run("render scenes/cube.json --size 32x24 --engine model -o " + path("b.png") + " --frame " + path("b.frame") +
                " --hits " + path("b.hits"))
                .code,
            0);
  EXPECT_EQ(read(path("a.frame")), read(path("b.frame")));
  EXPECT_EQ(read(path("a.hits")), read(path("b.hits")));
}

TEST_F(UioCommand, SaysWhatWasChosen) {
  for (const std::string& command : {"render scenes/cube.geo --size 32x24 -o " + path("a.png"), std::string("query scenes/teapot.geo scenes/rays.csv")}) {
    const Outcome outcome = on_core(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(says(outcome.err, {"default: camera eye", "default: background"}));
  }
}

TEST_F(UioCommand, AnswersWhatTheModelDoes) {
  const std::string query = "query scenes/teapot.json scenes/rays.csv";
  const Outcome outcome = on_core(query + " --check");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  EXPECT_TRUE(says(outcome.err, {"simulated core", "hit records differ"}));
  EXPECT_EQ(outcome.out, run(query + " --engine model").out);
}

TEST_F(UioCommand, ADifferenceIsOne) {
  core_->lies[static_cast<unsigned>(RegCounters + 8 * CntHits)] = 0;
  EXPECT_EQ(on_core(render_ + " --check").code, 1);
}

TEST_F(UioCommand, WithoutABoardOneLine) {
  expect_one_line(run(render_ + " --engine uio"), 4, {"castray: no board", "docs/uio.md"});
  expect_one_line(run("query scenes/teapot.json scenes/rays.csv --engine uio"), 4, {"castray: no board", "docs/uio.md"});
  // A mesh alone leaves much to defaults: they are printed where the board is there.
  expect_one_line(run("render scenes/cube.geo -o " + path("a.png") + " --engine uio"), 4, {"castray: no board"});
  expect_one_line(run("query scenes/teapot.geo scenes/rays.csv --engine uio"), 4, {"castray: no board"});
}

TEST_F(UioCommand, AnotherCoreOneLine) {
  expect_one_line(on_files(render_), 4, {"uio0", "version", "0x00000000", "bitstream"});
  set_register(RegVersion, VersionMajor << 16 | VersionMinor << 8 | VersionPatch);
  expect_one_line(on_files(render_), 4, {"uio0", "parameters", "bitstream"});
  set_register(RegParameters, ImageParameters);
  expect_one_line(on_files(render_), 4, {"uio0", "configuration", "bitstream"});
  set_register(RegConfig, 3 | 32 << 8 | 8 << 16);
  expect_one_line(on_files(render_ + " --timeout 0.05"), 4, {"uio0", "busy", "bitstream"});
  expect_one_line(on_files(render_ + " --uio castle"), 4, {"no board", "castle"});
  expect_one_line(on_files(render_ + " --udmabuf other"), 4, {"other", "u-dma-buf"});
}

TEST_F(UioCommand, BadOptionsAreRefused) {
  expect_refused(render_ + " --engine uio --timeout 0", 2, {"--timeout"});
  expect_refused(render_ + " --engine uio --timeout soon", 2, {"--timeout", "soon"});
  expect_refused(render_ + " --engine uio --udmabuf a --reserved 0:4096", 2, {"--udmabuf", "--reserved"});
  expect_refused(render_ + " --engine uio --trace " + path("t.fst") + " --trace-window 1:2", 2, {"--trace", "rtl"});
}

TEST_F(UioCommand, AHangIsGivenUp) {
  core_->deaf = true;
  expect_one_line(on_core(render_ + " --timeout 0.1"), 4, {"does not end", "idle again"});
}

TEST_F(UioCommand, AFrameThatDoesNotFitIsRefused) {
  expect_one_line(on_core("render scenes/cube.json --size 640x480 -o " + path("a.png")), 4,
                  {"udmabuf0", "make the buffer larger"});
  expect_one_line(on_core("render scenes/cube.geo --size 640x480 -o " + path("a.png")), 4, {"udmabuf0"});
  EXPECT_EQ(core_->starts, 0u);
}

}  // namespace
}  // namespace castray::tb
