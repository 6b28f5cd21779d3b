// SPDX-License-Identifier: Apache-2.0
// A core that errs in a list of rays: castray query --check names the ray, its line, both records and the
// command that replays it; errors and broken rules of the bus end with their exit codes.
// Cores: l1c32t3p1m0 l3c32t3p2m128
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "query_command.hpp"

namespace castray::tb {
namespace {

// A core whose answers are the model's, but for what `fault` does to them.
template <class Fault> sim::QueryRtl erring(Fault fault) {
  return [fault](const SceneImage& image, std::span<const std::uint8_t> rays, const sim::RtlOptions&, const sim::QueryOptions& options, const sim::Progress&) {
    sim::RtlQuery run;
    run.device = "a core that errs";
    run.answers = sim::query_model(image, rays, options);
    fault(run);
    return run;
  };
}
sim::QueryRtl other_primitive(std::size_t ray) {
  return erring([=](sim::RtlQuery& run) { run.answers.hits.at(ray * HitBytes + 12) ^= 1; });
}

class QueryMismatch : public QueryCommand {
 protected:
  // Three rays that hit the cube, a comment between them.
  void SetUp() override {
    CommandLine::SetUp();
    file("a list.csv", kColumns + "0.3,0.2,5,0,0,-1\n# here\n0.3,5,0.1,0,-1,0\n5,0.2,0.1,-1,0,0\n");
  }
  const std::string rays_ = path("a list.csv");
  const std::string ask_ = "scenes/cube.json " + cli::shell_word(rays_) + " --check -o " + path("a.csv") + " ";
};

TEST_F(QueryMismatch, NamesTheRayAndBothRecords) {
  const Outcome outcome = query(ask_ + "--json " + path("a.json"), other_primitive(1));
  EXPECT_EQ(outcome.code, cli::kMismatch) << outcome.err;
  const std::size_t at = outcome.out.find("  against the model: 1 of 3 hit records differ\n  ray 1, " + rays_ + ":4\n    ray    org_x=");
  ASSERT_NE(at, std::string::npos) << outcome.out;
  const auto prim = [&](const char* who) {
    const std::size_t line = outcome.out.find(who, at), field = outcome.out.find(" prim=", line);
    return std::stoi(outcome.out.substr(field + 6));
  };
  EXPECT_EQ(prim("\n    rtl    t="), prim("\n    model  t=") ^ 1);
  EXPECT_NE(outcome.out.find("\n    castray query scenes/cube.json " + cli::shell_word(rays_) + " --only 1 --check --mode bvh_root\n"), std::string::npos) << outcome.out;
  EXPECT_EQ(nlohmann::json::parse(read(path("a.json")))["hits_differ"], 1);
  EXPECT_EQ(table(read(path("a.csv"))).size(), 3u) << "the answers are written, as a picture is";
}

TEST_F(QueryMismatch, TheReplayShowsTheSameRay) {
  const Outcome all = query(ask_ + "--lanes 1 --ports 1 --l2 0 --seed 5", other_primitive(2));
  const std::size_t at = all.out.find("castray query ") + 14;
  const std::string replay = all.out.substr(at, all.out.find('\n', at) - at);
  EXPECT_NE(replay.find("--lanes 1"), std::string::npos);
  EXPECT_NE(replay.find("--seed 5"), std::string::npos);
  const Outcome one = query(replay, other_primitive(0));
  EXPECT_EQ(one.code, cli::kMismatch) << one.err;
  const std::string records = all.out.substr(all.out.find("  ray 2, "), all.out.find("    castray query") - all.out.find("  ray 2, "));
  EXPECT_NE(one.err.find(records), std::string::npos) << records << "not in:\n" << one.err;
}

TEST_F(QueryMismatch, TheFirstFewOfMany) {
  std::string text = kColumns;
  for (int i = 0; i < 100; ++i) text += "0.3,0.2,5,0,0,-1\n";
  const std::string many = file("many.csv", text);
  const Outcome outcome = query("scenes/cube.json " + many + " --check -o " + path("a.csv"), erring([](sim::RtlQuery& run) {
                                  for (std::size_t i = 0; i < run.answers.hits.size(); i += HitBytes) run.answers.hits[i] ^= 1;
                                }));
  EXPECT_EQ(outcome.code, cli::kMismatch);
  EXPECT_NE(outcome.out.find("100 of 100 hit records differ"), std::string::npos) << outcome.out;
  std::size_t commands = 0;
  for (std::size_t at = 0; (at = outcome.out.find("castray query ", at)) != std::string::npos; ++at) ++commands;
  EXPECT_EQ(commands, 8u);
}

TEST_F(QueryMismatch, CountersAreComparedToo) {
  for (const auto counter : {CntTests, CntRays, CntHits, CntCandidates, CntNodes}) {
    const Outcome outcome = query(ask_, erring([=](sim::RtlQuery& run) { ++run.answers.counters[static_cast<std::size_t>(counter)]; }));
    EXPECT_EQ(outcome.code, cli::kMismatch);
    EXPECT_NE(outcome.out.find("\n  counter "), std::string::npos) << outcome.out;
  }
}

TEST_F(QueryMismatch, NothingDiffers) {
  const Outcome outcome = query(ask_, erring([](sim::RtlQuery&) {}));
  EXPECT_EQ(outcome.code, cli::kOk) << outcome.err;
  EXPECT_NE(outcome.out.find("  against the model: 0 of 3 hit records differ\n"), std::string::npos) << outcome.out;
}

TEST_F(QueryMismatch, AnErrorOfTheCoreLeavesNoAnswers) {
  const Outcome outcome = query(ask_, erring([](sim::RtlQuery& run) { run.answers.error = ErrReadBus; }));
  EXPECT_EQ(outcome.code, cli::kDeviceError);
  EXPECT_NE(outcome.err.find("error 8: "), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(path("a.csv")));
  EXPECT_EQ(query("scenes/cube.json " + cli::shell_word(rays_), erring([](sim::RtlQuery& run) { run.answers.error = ErrReadBus; })).out, "");
}

TEST_F(QueryMismatch, BrokenRulesOfTheBus) {
  const Outcome outcome = query(ask_, erring([](sim::RtlQuery& run) {
                                  run.violations = 2;
                                  run.messages = {"cycle 7: a rule", "cycle 9: another"};
                                }));
  EXPECT_EQ(outcome.code, cli::kBusRules);
  EXPECT_NE(outcome.out.find("cycle 9: another"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace castray::tb
