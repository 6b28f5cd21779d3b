// SPDX-License-Identifier: Apache-2.0
#include "bench_tables.hpp"

#include "bench_text.hpp"
#include "bench_tree.hpp"

namespace castray::bench {
namespace {

constexpr std::uint64_t kTeapotTests = 76'800ULL * 6'320ULL;

std::string frames(const std::vector<Json>& records) {
  std::string out =
      "\n## The report's frame\n"
      "Teapot of 6,320 triangles at 320x240, three lanes, brute force, `reference` memory, the hit buffer written as well.\n"
      "The report: 166.5 M cycles (1.665 s at 100 MHz); its limit, every test of three lanes in one cycle: 161.8 M.\n\n"
      "| view | cycles | of the report's | of its limit | tests | pixels / hits that differ from the model | simulated |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "frames"))
    out += format("| %s | %.3f M | %.4f | %.4f | %lu | %s | %.2f M cycles/s |\n", text(r, "view").c_str(), mega(r),
                  r["cycles"].get<double>() / kReportCycles, r["cycles"].get<double>() / kReportBound,
                  r["tests"].get<unsigned long>(), differ(r).c_str(), r["cycles_per_second"].get<double>() / 1e6);
  return out;
}

std::string ladder(const std::vector<Json>& records) {
  std::string out =
      "\n## The ladder (the report's Table II)\n"
      "The teapot's base view at 80x60. The report's own rungs, at 320x240: floating point 2400 s; fixed point 97.33; primitives in\n"
      "BRAM 39.37; unrolled, CORDIC root 6.651; 4.993; 5.012; 4.964; three lanes 1.665 s.\n\n"
      "| lanes | contexts a lane | cycles | times the first rung | tests a cycle | differ |\n|---|---|---|---|---|---|\n";
  const std::vector<Json> rungs = only(records, "ladder");
  for (const Json& r : rungs)
    out += format("| %d | %d | %.3f M | %.2f | %.3f | %s |\n", r["lanes"].get<int>(), r["contexts"].get<int>(), mega(r),
                  mega(rungs[0]) / mega(r), r["tests"].get<double>() / r["cycles"].get<double>(), differ(r).c_str());
  return out;
}

std::string tiles(const std::vector<Json>& records) {
  std::string out =
      "\n## Tiles and their walk\nThe teapot's base view at 80x60, three lanes.\n\n"
      "| tile | walk | cycles | attributes fetched | read beats | write beats | differ |\n|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "tiles"))
    out += format("| %dx%d | %s | %.4f M | %lu | %lu | %lu | %s |\n", r["tile"].get<int>(), r["tile"].get<int>(),
                  text(r, "walk").c_str(), mega(r), r["attr_misses"].get<unsigned long>(), r["read_beats"].get<unsigned long>(),
                  r["write_beats"].get<unsigned long>(), differ(r).c_str());
  return out +
         "\nBy brute force the tile hardly matters, for every ray meets every primitive: cycles differ by the last, part-filled batch and by\n"
         "the attributes that neighbouring pixels share. Tiles of 8x8 in rows are the default: their rows are whole bursts of 32 bytes, one\n"
         "tile needs a quarter of the gather buffer of 16x16, and the hierarchy starts its rays by tiles of that size.\n";
}

std::string transforms(const std::vector<Json>& records) {
  std::string out =
      "\n## Transforms (the report's section VIII)\nThe same latency under rotations, flips and zooms, 80x60, three lanes.\n\n"
      "| view | cycles | against base | differ |\n|---|---|---|---|\n";
  const std::vector<Json> runs = only(records, "transforms");
  for (const Json& r : runs)
    out += format("| %s | %.4f M | %+.4f%% | %s |\n", text(r, "view").c_str(), mega(r), 100 * (mega(r) / mega(runs[0]) - 1),
                  differ(r).c_str());
  return out;
}

std::string stalls(const std::vector<Json>& records) {
  std::string out =
      "\n## Stalls\n80x60, three lanes, responses of different IDs reordered. The share of the cycles in which a channel was wanted and\n"
      "blocked; `turn` shuts one channel after the other. For the base view without stalls see *Transforms*.\n\n"
      "| view | pattern | cycles | ar | r | aw | w | b | differ |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "stalls"))
    out += format("| %s | %s | %.3f M |%s %s |\n", text(r, "view").c_str(), text(r, "stalls").c_str(), mega(r), blocked(r).c_str(), differ(r).c_str());
  return out;
}

std::string reference(const std::vector<Json>& records) {
  std::string out =
      "\n## Against float64\nThe model (equal to the RTL) against the float64 tracer, which reads the scene file and shares nothing with it.\n\n"
      "| scene | view | frame | see another primitive | another cell of the checker | of the rest: more than 1 of 255 away | farthest |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "reference"))
    out += format("| %s | %s | %s | %lu | %lu | %lu | %d |\n", text(r, "scene").c_str(), text(r, "view").c_str(),
                  size_of(r).c_str(), r["other_primitive"].get<unsigned long>(), r["other_cell"].get<unsigned long>(),
                  r["far_colour"].get<unsigned long>(), r["worst_colour"].get<int>());
  return out;
}

std::string compiled(const std::vector<Json>& records) {
  std::string out =
      "\n## Scene images\nFrom a scene in memory to its image: grid, hierarchy, bytes. One thread.\n\n"
      "| scene | primitives | seconds | image, MB | nodes | leaves | levels |\n|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "compile"))
    out += format("| %s | %lu | %.2f | %.2f | %lu | %lu | %u |\n", text(r, "scene").c_str(), r["primitives"].get<unsigned long>(),
                  r["compile_seconds"].get<double>(), r["image_bytes"].get<double>() / 1e6, r["nodes"].get<unsigned long>(),
                  r["leaves"].get<unsigned long>(), r["levels"].get<unsigned>());
  return out;
}

std::string host(const std::vector<Json>& records) {
  std::string out =
      "\n## C++ on the host (the report's Tables I and III)\n"
      "Brute force, one thread, all timed in this run. The report: Table I, C code at 128x96, field of view 90: 75 min 14.3 s; Table III,\n"
      "floating point 21.43 s and fixed point 12 min 17 s at 320x240.\n\n"
      "| frame | field of view | float64 | float32 | fixed point, bit-accurate | fixed point / float32 |\n|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "host"))
    out += format("| %s | %.0f | %.2f s | %.2f s | %.2f s | %.1f |\n", size_of(r).c_str(), r["field_of_view"].get<double>(),
                  r["float64_seconds"].get<double>(), r["float32_seconds"].get<double>(), r["fixed_seconds"].get<double>(),
                  r["fixed_seconds"].get<double>() / r["float32_seconds"].get<double>());
  for (const Json& s : only(records, "speed"))
    out += format("\nThe Verilated three-lane core, all lanes busy, alone on the machine: %.2f M cycles/s.\n",
                  s["cycles_per_second"].get<double>() / 1e6);
  return out;
}

std::string embree(const std::vector<Json>& records) {
  std::string out =
      "\n## Embree\nThe same frames through Embree 3 (`RTC_SCENE_FLAG_ROBUST`, float32), one thread: its build, and rays a second one at a time and in\n"
      "packets of neighbouring pixels, coherent. Where it sees another primitive than the model, in double: the line passes the edge of\n"
      "the nearer primitive within float32's rounding, or two surfaces are as near. Float64 sides with the model in as many as the last column says.\n\n"
      "| scene | view | build | 1 | 4 | 8 | 16 | see another primitive | edges | ties | unexplained | float64 with the model |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "embree")) {
    out += format("| %s | %s | %.2f s |", text(r, "scene").c_str(), text(r, "view").c_str(), r["build_seconds"].get<double>());
    for (const char* packet : {"1", "4", "8", "16"})
      out += format(" %.2f M/s |", r["rays_per_second"][packet].get<double>() / 1e6);
    for (const char* key : {"other_primitive", "edges", "ties", "unexplained", "float64_with_model"})
      out += format(" %lu |", r[key].get<unsigned long>());
    out += "\n";
  }
  return out;
}

}  // namespace

std::string page_of(const std::vector<Json>& records) {
  std::string page =
      "# Bench\nWritten by `make bench`, which runs everything on this page; the same figures stand in `build/bench.json`. Cycles are the RTL's own\n"
      "counter, from the accepted start to done.\n";
  const std::pair<const char*, std::string (*)(const std::vector<Json>&)> sections[] = {
      {"tree", tree},     {"tree_tiles", tree_tiles}, {"tree_stalls", tree_stalls},
      {"list", lists},    {"compile", compiled},
      {"frames", frames}, {"ladder", ladder}, {"transforms", transforms},
      {"tiles", tiles},   {"stalls", stalls}, {"reference", reference},
      {"embree", embree}, {"host", host}};
  for (const auto& [part, section] : sections)
    if (!only(records, part).empty()) page += section(records);
  return page;
}

std::vector<std::string> broken_bars(const std::vector<Json>& records) {
  std::vector<std::string> broken;
  const auto check = [&](bool holds, const std::string& bar, const Json& r) {
    if (!holds) broken.push_back(bar + ": " + r.dump());
  };
  for (const Json& r : records) {
    if (r["engine"] == "rtl") {
      check(r["pixels_differ"] == 0 && r["hits_differ"] == 0 && r["counters_differ"] == 0, "RTL equals model", r);
      check(r["error"] == 0 && r["rules_broken"] == 0, "no error, no rule of the bus broken", r);
    }
    if (r["part"] == "frames" && r["view"] == "base") check(r["cycles"] <= 163'500'000, "at most 163.5 M cycles", r);
    if (r["part"] == "frames") check(r["tests"] == kTeapotTests, "485,376,000 tests", r);
    if (r["part"] == "stalls" || r["part"] == "tree_stalls")
      for (const char* channel : kChannels)
        check(r["blocked"].value(channel, 0.0) >= 0.25, "a quarter of the wanted cycles blocked", r);
    if (r["part"] == "reference") {
      const double rate = (r["scene"] == "spheres" ? 8 : 4) / 76'800.0;
      check(r["other_primitive"].get<double>() <= std::max(rate * r["pixels"].get<double>(), r["pixels"] < 76'800 ? 1.0 : 0.0),
            "pixels that see another primitive", r);
      check(r["far_colour"] == 0, "colours within 1 of 255", r);
    }
    if (r["part"] == "embree")
      check(r["unexplained"] == 0 && r["other_primitive"].get<double>() * 76'800 <= 16 * r["pixels"].get<double>(),
            "at most 16 of 76,800 pixels differ from Embree, each explained", r);
    if (r["part"] == "list" && r["memory"] == "reference") check(r["cycles"] <= 400'000, "at most 400,000 cycles", r);
    if (const std::uint64_t bar = bar_of(r)) check(r["cycles"] <= bar, "at most " + std::to_string(bar) + " cycles", r);
    if (r["part"] == "tree_speed") check(r["seconds"] < 1, "a frame through the simulated core in under a second", r);
    if (r["part"] == "speed") check(r["cycles_per_second"] >= 0.4e6, "0.4 M cycles/s", r);
  }
  const std::vector<Json> moved = only(records, "transforms");
  for (const Json& r : moved) check(std::abs(mega(r) / mega(moved[0]) - 1) <= 0.001, "transforms within 0.1%", r);
  return broken;
}

}  // namespace castray::bench
