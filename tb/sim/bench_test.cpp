// SPDX-License-Identifier: Apache-2.0
// The bench's records have the keys that are promised of each; every bar that does not hold is named; the page has the tables
// of the parts that were run. On records of small frames, changed to stand for those of the bench.
// Cores: l3c32t3p2m128
#include <gtest/gtest.h>

#include "bench_runs.hpp"
#include "bench_tables.hpp"

namespace castray::tb {
namespace {

using bench::Json;

const bench::Frame kFrame{"cube", "cube", "base", 16, 12};

// One record of each kind.
const std::map<std::string, Json>& kinds() {
  static const std::map<std::string, Json> records = {
      {"rtl", bench::rtl_run(kFrame, {.stalls = "uniform", .mode = sim::Mode::kBvh})}, {"list", bench::list_run(kFrame, {.mode = sim::Mode::kBvhRoot})},
      {"compile", bench::compile_run(kFrame)}, {"reference", bench::reference_run(kFrame)},
      {"embree", bench::embree_run(kFrame)},   {"host", bench::host_run(kFrame, 0)}};
  return records;
}

TEST(BenchRecords, HaveTheKeysOfEveryRecord) {
  for (const auto& [kind, record] : kinds())
    for (const char* key : {"engine", "scene", "view", "mode", "width", "height", "lanes", "ports", "memory", "stalls", "cycles", "pixels", "pixels_differ", "hits_differ"})
      EXPECT_TRUE(record.contains(key)) << kind << ": " << key;
  for (const char* kind : {"rtl", "list"})
    for (const char* key : {"lanes", "ports", "memory", "cycles", "pixels_differ", "hits_differ"})
      EXPECT_TRUE(!kinds().at(kind)[key].is_null()) << kind << ": " << key;
  EXPECT_EQ(kinds().at("rtl")["stalls"], "uniform");
  for (const char* kind : {"compile", "reference", "embree", "host"}) EXPECT_TRUE(kinds().at(kind)["cycles"].is_null()) << kind;
}

// A record of a part: one of a kind with some keys set.
Json record(const std::string& part, const char* kind, const Json& set = Json::object()) {
  Json r = {{"part", part}};
  r.update(kinds().at(kind));
  r.merge_patch(set);
  return r;
}

// What holds every bar: each as near to it as it may be.
std::vector<Json> good() {
  const Json open = {{"ar", 0.25}, {"r", 0.25}, {"aw", 0.25}, {"w", 0.25}, {"b", 0.25}};
  const Json default_core = {{"stalls", nullptr}, {"width", 320}};
  const auto tree = [&](const char* scene, const char* view, const char* mode, int cycles) {
    Json set = default_core;
    set.update({{"scene", scene}, {"view", view}, {"mode", mode}, {"cycles", cycles}});
    return record("tree", "rtl", set);
  };
  return {record("frames", "rtl", {{"cycles", 163'500'000}, {"tests", 485'376'000}}),
          record("ladder", "rtl"),
          record("tiles", "rtl"),
          record("transforms", "rtl", {{"cycles", 1'000'000}}),
          record("transforms", "rtl", {{"cycles", 1'001'000}, {"view", "zoomed"}}),
          record("stalls", "rtl", {{"blocked", open}}),
          record("tree_stalls", "rtl", {{"blocked", open}}),
          record("tree_tiles", "rtl"),
          tree("teapot", "base", "bvh", 100'000),
          tree("teapot", "tight", "bvh", 180'000),
          tree("teapot", "base", "bvh_root", 180'000),
          tree("teapot100k", "base", "bvh", 240'000),
          tree("teapot1m", "base", "bvh", 500'000),
          record("tree_speed", "rtl", {{"seconds", 0.99}}),
          record("speed", "rtl", {{"cycles_per_second", 0.4e6}}),
          record("list", "list", {{"cycles", 400'000}}),
          record("compile", "compile"),
          record("reference", "reference", {{"pixels", 76'800}, {"other_primitive", 4}}),
          record("reference", "reference", {{"pixels", 76'800}, {"other_primitive", 8}, {"scene", "spheres"}}),
          record("embree", "embree", {{"pixels", 76'800}, {"other_primitive", 16}}),
          record("host", "host")};
}

TEST(BenchBars, HoldAtTheirEdge) { EXPECT_EQ(bench::broken_bars(good()), std::vector<std::string>{}); }

// Each broken alone is named, alone.
TEST(BenchBars, EachIsNamedWhereItIsBroken) {
  struct Break {
    Json where;   // the record whose keys have these values
    Json set;
    const char* bar;
  };
  const std::vector<Break> breaks = {
      {{{"part", "ladder"}}, {{"pixels_differ", 1}}, "RTL equals model"},
      {{{"part", "tree_tiles"}}, {{"pixels_differ", 1}}, "RTL equals model"},
      {{{"part", "tree_stalls"}}, {{"hits_differ", 1}}, "RTL equals model"},
      {{{"part", "list"}}, {{"hits_differ", 1}}, "RTL equals model"},
      {{{"part", "tiles"}}, {{"error", 1}}, "no error"},
      {{{"part", "tiles"}}, {{"rules_broken", 1}}, "no rule of the bus broken"},
      {{{"part", "frames"}}, {{"cycles", 163'500'001}}, "163.5 M cycles"},
      {{{"part", "frames"}}, {{"tests", 485'375'999}}, "485,376,000 tests"},
      {{{"part", "stalls"}}, {{"blocked", {{"ar", 0.24}}}}, "a quarter"},
      {{{"part", "stalls"}}, {{"blocked", {{"r", 0.24}}}}, "a quarter"},
      {{{"part", "stalls"}}, {{"blocked", {{"aw", 0.24}}}}, "a quarter"},
      {{{"part", "stalls"}}, {{"blocked", {{"w", 0.24}}}}, "a quarter"},
      {{{"part", "stalls"}}, {{"blocked", {{"b", nullptr}}}}, "a quarter"},
      {{{"part", "tree_stalls"}}, {{"blocked", {{"r", 0.24}}}}, "a quarter"},
      {{{"part", "reference"}, {"scene", "cube"}}, {{"other_primitive", 5}}, "another primitive"},
      {{{"part", "reference"}, {"scene", "spheres"}}, {{"other_primitive", 9}}, "another primitive"},
      {{{"part", "reference"}, {"scene", "cube"}}, {{"far_colour", 1}}, "1 of 255"},
      {{{"part", "embree"}}, {{"other_primitive", 17}}, "Embree"},
      {{{"part", "embree"}}, {{"unexplained", 1}}, "Embree"},
      {{{"part", "list"}}, {{"cycles", 400'001}}, "400,000 cycles"},
      {{{"part", "tree"}, {"scene", "teapot"}, {"view", "base"}, {"mode", "bvh"}}, {{"cycles", 100'001}}, "100000 cycles"},
      {{{"part", "tree"}, {"view", "tight"}}, {{"cycles", 180'001}}, "180000 cycles"},
      {{{"part", "tree"}, {"mode", "bvh_root"}}, {{"cycles", 180'001}}, "180000 cycles"},
      {{{"part", "tree"}, {"scene", "teapot100k"}}, {{"cycles", 240'001}}, "240000 cycles"},
      {{{"part", "tree"}, {"scene", "teapot1m"}}, {{"cycles", 500'001}}, "500000 cycles"},
      {{{"part", "tree_speed"}}, {{"seconds", 1}}, "under a second"},
      {{{"part", "speed"}}, {{"cycles_per_second", 0.39e6}}, "0.4 M cycles/s"},
      {{{"part", "transforms"}, {"view", "zoomed"}}, {{"cycles", 1'001'001}}, "within 0.1%"},
  };
  for (const Break& change : breaks) {
    std::vector<Json> records = good();
    const auto at = std::ranges::find_if(records, [&](const Json& r) {
      return std::ranges::all_of(change.where.items(), [&](const auto& item) { return r[item.key()] == item.value(); });
    });
    ASSERT_NE(at, records.end()) << change.where;
    at->merge_patch(change.set);
    const std::vector<std::string> broken = bench::broken_bars(records);
    ASSERT_EQ(broken.size(), 1u) << change.where << change.set;
    EXPECT_NE(broken[0].find(change.bar), std::string::npos) << broken[0];
  }
}

// A bar of the hierarchy is of the default core: not of another that is slower.
TEST(BenchBars, OfTheHierarchyAreOfTheDefaultCore) {
  for (const Json& other : {Json{{"lanes", 1}}, {{"ports", 1}}, {{"l2_kbytes", 0}}, {{"contexts", 1}}, {{"memory", "hp"}}, {{"width", 640}}}) {
    Json r = record("tree", "rtl", {{"scene", "teapot"}, {"width", 320}, {"cycles", 1'000'000}});
    EXPECT_EQ(bench::broken_bars({r}).size(), 1u);
    r.update(other);
    EXPECT_EQ(bench::broken_bars({r}).size(), 0u) << other;
  }
}

TEST(BenchPage, HasTheTablesOfTheParts) {
  const std::string page = bench::page_of(good());
  for (const char* title : {"The hierarchy", "Tiles in the hierarchy", "Stalls in the hierarchy", "A list of rays", "Scene images", "The report's frame", "The ladder", "Transforms",
                            "Tiles and their walk", "Stalls", "Against float64", "Embree", "C++ on the host"})
    EXPECT_NE(page.find(std::string("\n## ") + title), std::string::npos) << title;
  EXPECT_NE(page.find("| teapot | base | 320x12 | bvh | 3 | 2 | 128 | reference | 100000 | 100000 | 1665 |"), std::string::npos);
  const std::string one = bench::page_of({record("list", "list")});
  EXPECT_NE(one.find("\n## A list of rays"), std::string::npos);
  EXPECT_EQ(one.find("\n## ", one.find("\n## ") + 1), std::string::npos);
}

// As many cells in each row as in its table's head.
TEST(BenchPage, HasWholeRows) {
  std::istringstream lines(bench::page_of(good()));
  std::size_t cells = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t here = static_cast<std::size_t>(std::ranges::count(line, '|'));
    if (here > 0 && cells > 0) EXPECT_EQ(here, cells) << line;
    cells = here;
  }
}

}  // namespace
}  // namespace castray::tb
