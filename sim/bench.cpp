// SPDX-License-Identifier: Apache-2.0
// `make bench`: full frames, the ladder, sweeps and timings; prints docs/bench.md and writes
// build/bench.json. Exits with 1 if a bar does not hold.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <mutex>
#include <thread>

#include "bench_tables.hpp"
#include "scene/files.hpp"

namespace {

using namespace castray::bench;

struct Run {
  std::string part;
  std::string name;
  std::function<Json()> measure;
};

const std::vector<std::pair<const char*, const char*>> kViews = {
    {"teapot", "base"}, {"teapot_tight", "tight"}, {"teapot_fit", "fit"}, {"teapot_interior", "interior"}};
const std::vector<std::pair<const char*, const char*>> kMoved = {
    {"teapot_rotated", "rotated"}, {"teapot_flipped", "flipped"}, {"teapot_zoomed", "zoomed"}};

// The scenes that the hierarchy is measured on, at 320x240: file, scene, view.
const std::vector<Frame> kTreeFrames = {
    {"teapot", "teapot", "base", 320, 240},         {"teapot_tight", "teapot", "tight", 320, 240},
    {"teapot_fit", "teapot", "fit", 320, 240},      {"teapot_interior", "teapot", "interior", 320, 240},
    {"teapot100k", "teapot100k", "base", 320, 240}, {"teapot1m", "teapot1m", "base", 320, 240},
    {"spheres4k", "spheres4k", "base", 320, 240},   {"field", "field", "base", 320, 240}};
// A core as the bars of the hierarchy ask for it, without the hit buffer.
Core tree_core(castray::sim::Mode mode = castray::sim::Mode::kBvh) { return {.hits = false, .mode = mode}; }

// What is timed runs alone, one after the other; it comes first.
std::vector<Run> timed_runs() {
  std::vector<Run> runs = {
      {"tree_speed", "simulated speed, hierarchy", [] { return rtl_run(kTreeFrames[0], tree_core()); }},
      {"speed", "simulated speed", [] { return rtl_run({"teapot"}, {}); }},
      {"host", "C++ at 320x240", [] { return host_run({"teapot", "teapot", "base", 320, 240}, 0); }},
      {"host", "C++ at 128x96", [] { return host_run({"teapot", "teapot", "base", 128, 96}, 90); }},
      {"embree", "Embree, spheres", [] { return embree_run({"spheres", "spheres", "base", 320, 240}); }},
  };
  for (const Frame& frame : kTreeFrames) {
    if (frame.view == "base") runs.push_back({"compile", "compile " + frame.scene, [=] { return compile_run(frame); }});
    runs.push_back({"embree", "Embree, " + frame.scene + " " + frame.view, [=] { return embree_run(frame); }});
  }
  return runs;
}

std::string name_of(const Frame& frame, const Core& core) {
  return frame.scene + " " + frame.view + " " + std::to_string(frame.width) + ", " +
         castray::sim::kModeNames[static_cast<std::size_t>(core.mode)] + ", " + std::to_string(core.lanes) + " lanes of " +
         std::to_string(core.contexts) + ", tiles " + std::to_string(1 << core.tile_log2) + (core.z_order ? " z, " : ", ") +
         std::to_string(core.ports) + " ports, L2 " + std::to_string(core.l2_kbytes) + ", " + core.memory + ", stalls " + core.stalls;
}

// Frames in the hierarchy: every scene in both modes and both memories, then lanes, contexts, ports and sizes of the second cache,
// then larger frames, tiles and stalls.
std::vector<Run> tree_runs() {
  using castray::sim::Mode;
  std::vector<Run> runs;
  const auto add = [&](const Frame& frame, const Core& core, const char* part = "tree") {
    runs.push_back({part, name_of(frame, core), [=] { return rtl_run(frame, core); }});
  };
  for (const Frame& frame : kTreeFrames) {
    add(frame, tree_core());
    add(frame, tree_core(Mode::kBvhRoot));
    Core hp = tree_core();
    hp.memory = "hp";
    add(frame, hp);
  }
  for (const char* scene : {"teapot", "teapot100k"})
    for (const auto& [lanes, ports, l2] : {std::array{1, 2, 128}, {2, 2, 128}, {4, 2, 128}, {8, 2, 128}, {3, 2, 0}, {3, 1, 128}, {3, 1, 0}}) {
      Core core = tree_core();
      core.lanes = lanes, core.ports = ports, core.l2_kbytes = l2;
      add({scene, scene, "base", 320, 240}, core);
    }
  Core one = tree_core();
  one.lanes = one.contexts = 1;
  add(kTreeFrames[0], one);
  add({"teapot", "teapot", "base", 640, 480}, tree_core());
  add({"teapot", "teapot", "base", 1920, 1080}, tree_core());
  for (const int log2 : {2, 3, 4})
    for (const bool z : {false, true}) {
      Core core = tree_core();
      core.tile_log2 = log2, core.z_order = z;
      add(kTreeFrames[0], core, "tree_tiles");
    }
  const auto stalled = [&](const Frame& frame, int lanes, const char* pattern) {
    Core core = tree_core();
    core.hits = true, core.lanes = lanes, core.stalls = pattern;
    add(frame, core, "tree_stalls");
  };
  for (const int lanes : {1, 2, 3, 4})
    for (const char* pattern : {"uniform", "bursty", "turn"}) stalled({"teapot"}, lanes, pattern);
  for (const char* scene : {"teapot100k", "teapot1m"})
    for (const auto& [lanes, pattern] : {std::pair{1, "uniform"}, {2, "bursty"}, {4, "turn"}}) stalled({scene, scene, "base", 320, 240}, lanes, pattern);
  return runs;
}

// The base view's camera rays as a list: ports, and the other memory.
std::vector<Run> list_runs() {
  std::vector<Run> runs;
  for (const auto& [ports, memory] : {std::pair{1, "reference"}, {2, "reference"}, {1, "hp"}, {2, "hp"}}) {
    Core core = tree_core(castray::sim::Mode::kBvhRoot);
    core.hits = true, core.ports = ports, core.memory = memory;
    runs.push_back({"list", "list of camera rays, " + std::to_string(ports) + " ports, " + memory, [=] { return list_run(kTreeFrames[0], core); }});
  }
  return runs;
}

std::vector<Run> counted_runs() {
  std::vector<Run> runs = tree_runs();
  for (Run& run : list_runs()) runs.push_back(std::move(run));
  const auto add = [&](const char* part, std::string name, std::function<Json()> measure) {
    runs.push_back({part, std::move(name), std::move(measure)});
  };
  for (int i = 0; i < 2; ++i) {
    const Frame frame{kViews[i].first, "teapot", kViews[i].second, 320, 240};
    add("frames", "teapot " + frame.view + " 320x240", [=] { return rtl_run(frame, {}); });
  }
  for (const Core& rung : {Core{1, 1}, Core{1}, Core{2}, Core{3}, Core{4}, Core{8}})
    add("ladder", "ladder " + std::to_string(rung.lanes) + " x " + std::to_string(rung.contexts), [=] { return rtl_run({"teapot"}, rung); });
  for (const int log2 : {2, 3, 4})
    for (const bool z : {false, true})
      add("tiles", "tiles " + std::to_string(1 << log2) + (z ? " z" : " rows"), [=] { return rtl_run({"teapot"}, {3, 32, log2, z}); });
  add("transforms", "base", [] { return rtl_run({"teapot"}, {}); });
  for (const auto& moved : kMoved) add("transforms", moved.second, [=] { return rtl_run({moved.first, "teapot", moved.second}, {}); });
  for (int i = 0; i < 2; ++i)
    for (const char* pattern : {"uniform", "bursty", "turn"}) {
      const Frame frame{kViews[i].first, "teapot", kViews[i].second};
      add("stalls", std::string("stalls ") + frame.view + " " + pattern, [=] { return rtl_run(frame, {3, 32, 3, false, true, pattern}); });
    }
  const auto against = [&](const Frame& frame) {
    add("reference", frame.scene + " " + frame.view + " " + std::to_string(frame.width), [=] { return reference_run(frame); });
  };
  for (const auto& views : {kViews, kMoved})
    for (const auto& [file, view] : views) against({file, "teapot", view, 320, 240});
  against({"spheres", "spheres", "base", 320, 240});
  against({"cube", "cube", "base", 320, 240});
  against({"teapot", "teapot", "base", 640, 480});
  against({"teapot", "teapot", "base", 1920, 1080});
  return runs;
}

// Runs with a line for each start and end; `workers` at a time, results in the order of `runs`.
std::vector<Json> run_all(const std::vector<Run>& runs, unsigned workers) {
  std::vector<Json> records(runs.size());
  std::mutex mutex;
  std::size_t next = 0, done = 0;
  const auto work = [&] {
    for (;;) {
      std::unique_lock lock(mutex);
      if (next == runs.size()) return;
      const std::size_t i = next++;
      lock.unlock();
      Json record = {{"part", runs[i].part}};
      record.update(runs[i].measure());
      lock.lock();
      records[i] = std::move(record);
      std::fprintf(stderr, "  %2zu of %zu  %s\n", ++done, runs.size(), runs[i].name.c_str());
    }
  };
  std::vector<std::jthread> pool;
  for (unsigned i = 1; i < workers; ++i) pool.emplace_back(work);
  work();
  pool.clear();
  return records;
}

std::vector<Run> only(std::vector<Run> runs, const std::vector<std::string>& parts, const std::string& match) {
  std::erase_if(runs, [&](const Run& run) {
    return (!parts.empty() && std::ranges::find(parts, run.part) == parts.end()) || run.name.find(match) == std::string::npos;
  });
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Measure castray: full frames, the ladder, sweeps and timings."};
  std::string json = "build/bench.json", page, match;
  std::vector<std::string> parts;
  unsigned workers = std::max(1u, std::thread::hardware_concurrency());
  app.add_option("--json", json, "the records, a list of objects")->capture_default_str();
  app.add_option("--page", page, "the tables as Markdown; printed in any case");
  app.add_option("--only", parts, "these parts: tree tree_tiles tree_stalls list tree_speed compile speed host embree frames ladder tiles transforms stalls reference");
  app.add_option("--match", match, "runs whose name holds this");
  app.add_option("-j", workers, "runs at a time; what is timed runs alone")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::vector<Json> records = run_all(only(timed_runs(), parts, match), 1);
    for (Json& record : run_all(only(counted_runs(), parts, match), workers)) records.push_back(std::move(record));
    castray::write_file(json, Json(records).dump(1) + "\n");
    const std::string text = page_of(records);
    if (!page.empty()) castray::write_file(page, text);
    std::fputs(text.c_str(), stdout);
    const std::vector<std::string> broken = broken_bars(records);
    for (const std::string& bar : broken) std::printf("NOT HELD: %s\n", bar.c_str());
    return broken.empty() ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench: %s\n", e.what());
    return 2;
  }
}
