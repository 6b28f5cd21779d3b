// SPDX-License-Identifier: Apache-2.0
#include "bench_runs.hpp"

#include "bench_scenes.hpp"
#include "counter_names.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "camera_list.hpp"
#include "comparison.hpp"
#include "frame_run.hpp"
#include "reference/disagreement.hpp"
#include "reference/embree.hpp"
#include "reference/float32.hpp"
#include "reference/float64.hpp"
#include "reference_check.hpp"
#include "scene/tree_facts.hpp"

namespace castray::bench {
namespace {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What every record has: of what a run has no core or no comparison for, null.
Json head(const Frame& frame, const char* engine, sim::Mode mode) {
  Json record = {{"engine", engine},      {"scene", frame.scene},   {"view", frame.view}, {"mode", sim::kModeNames[static_cast<std::size_t>(mode)]},
                 {"width", frame.width}, {"height", frame.height}, {"pixels", frame.width * frame.height}};
  for (const char* key : {"lanes", "ports", "memory", "stalls", "cycles", "pixels_differ", "hits_differ"}) record[key] = nullptr;
  return record;
}

using sim::Counts;

sim::RtlOptions device_of(const Core& core) {
  sim::RtlOptions device;
  device.variant = {core.lanes, core.contexts, core.tile_log2, core.ports, core.l2_kbytes};
  device.timing = sim::AxiTiming::named(core.memory);
  device.timing.reorder = core.stalls != "none";
  device.stalls = core.stalls;
  return device;
}

void add_core(Json& record, const Core& core) {
  record["lanes"] = core.lanes;
  record["contexts"] = core.contexts;
  record["tile"] = 1 << core.tile_log2;
  record["walk"] = core.z_order ? "z" : "rows";
  record["ports"] = core.ports;
  record["l2_kbytes"] = core.l2_kbytes;
  record["memory"] = core.memory;
  record["stalls"] = core.stalls == "none" ? Json() : Json(core.stalls);
  record["hit_buffer"] = core.hits;
}

// The counters of a job, and what follows from them. A ray of a frame is a pixel, those of empty tiles too.
void add_counters(Json& record, const Counts& counts, double rays, const Core& core) {
  for (const auto& [index, name] : sim::kCounterNames) record[name] = counts[static_cast<std::size_t>(index)];
  const auto count = [&](const char* name) { return record[name].get<double>(); };
  const double cycles = count("cycles");
  record["rays_per_cycle"] = rays / cycles;
  record["nodes_per_ray"] = count("nodes") / rays;
  record["tests_per_ray"] = count("tests") / rays;
  record["read_bytes_per_ray"] = 16 * count("read_beats") / rays;
  record["write_bytes_per_ray"] = 16 * count("write_beats") / rays;
  Json& busy = record["utilisation"];   // shares of the cycles
  busy["node_pipe"] = count("nodes") / cycles / core.lanes;
  busy["primitive_pipe"] = count("tests") / cycles / core.lanes;
  busy["divider"] = count("candidates") / cycles;   // one hit unit for all lanes
  busy["tile_start"] = count("tile_busy") / cycles;
  busy["shading"] = count("shader_busy") / cycles;
  busy["read_ports"] = count("read_beats") / cycles / core.ports;
  busy["write_port"] = count("write_beats") / cycles;
  Json& rates = record["hit_rate"];
  for (const char* cache : {"node", "leaf", "tile", "l2", "attr"}) {
    const double hits = count((std::string(cache) + "_hits").c_str()), lookups = hits + count((std::string(cache) + "_misses").c_str());
    rates[cache] = lookups > 0 ? Json(hits / lookups) : Json();
  }
}

}  // namespace

Json rtl_run(const Frame& frame, const Core& core) {
  const auto image = image_of(frame);
  const sim::RtlOptions device = device_of(core);
  sim::RenderOptions options;
  options.hits = core.hits;
  options.mode = core.mode;
  options.z_order = core.z_order;
  const auto model_of = [&] { return sim::run_model(*image, options, {}, 1, core.tile_log2); };
  const sim::RtlRun run = sim::run_rtl(*image, device, options);
  const sim::Rendering model = model_of();
  const sim::Comparison comparison = sim::compare(run.rendering, model);
  options.hits = true;
  const sim::RtlRun hits = core.hits ? run : sim::run_rtl(*image, device, options);
  const sim::Rendering hits_model = core.hits ? model : model_of();

  Json record = head(frame, "rtl", core.mode);
  add_core(record, core);
  record["pixels_differ"] = comparison.pixels_differ;
  record["hits_differ"] = sim::compare(hits.rendering, hits_model).hits_differ;
  record["counters_differ"] = sim::counters_that_differ(run.rendering.counters, model.counters).size() +
                              sim::counters_that_differ(hits.rendering.counters, hits_model.counters).size();
  record["error"] = static_cast<int>(std::max(run.rendering.error, hits.rendering.error));
  record["rules_broken"] = run.violations + hits.violations;
  add_counters(record, run.rendering.counters, double(run.rendering.pixels.size()), core);
  record["seconds"] = run.seconds;
  record["cycles_per_second"] = run.cycles_per_second();
  if (core.stalls != "none")
    for (unsigned i = 0; i < sim::kChannels; ++i)
      if (run.shares[i].wanted > 0) record["blocked"][sim::kChannelNames[i]] = run.shares[i].share();
  return record;
}

Json list_run(const Frame& frame, const Core& core) {
  const auto image = image_of(frame);
  const std::vector<ray_record_t> rays = sim::camera_rays(*image);
  const std::vector<std::uint8_t> bytes = sim::bytes_of(rays);
  const sim::RtlQuery run = sim::query_rtl(*image, bytes, device_of(core), {.mode = core.mode});
  sim::Answers expected;
  expected.hits = sim::run_model(*image, {.mode = core.mode}, {}, 1).hits;

  Json record = head(frame, "rtl", core.mode);
  add_core(record, core);
  record["pixels_differ"] = 0;   // there are none
  record["hits_differ"] = sim::compare(run.answers, expected).hits_differ;
  record["counters_differ"] = sim::counters_that_differ(run.answers.counters, sim::query_model(*image, bytes, {.mode = core.mode}, {}, 1).counters).size();
  record["error"] = static_cast<int>(run.answers.error);
  record["rules_broken"] = run.violations;
  add_counters(record, run.answers.counters, double(rays.size()), core);
  record["seconds"] = run.seconds;
  record["cycles_per_second"] = run.cycles_per_second();
  return record;
}

Json compile_run(const Frame& frame) {
  const auto scene = scene_of(frame);
  SceneImage image;
  Json record = head(frame, "host", sim::Mode::kBvh);
  record["primitives"] = scene->primitives();
  record["compile_seconds"] = seconds_of([&] { image = compile(*scene, frame.width, frame.height); });
  record["image_bytes"] = image.bytes.size();
  const TreeFacts facts = tree_facts(image);
  record["nodes"] = facts.nodes;
  record["leaves"] = facts.leaves;
  record["levels"] = facts.depth;
  return record;
}

Json reference_run(const Frame& frame) {
  const auto scene = scene_of(frame);
  const auto image = image_of(frame);
  const sim::Rendering model = sim::run_model(*image);
  const sim::ReferenceCheck check = sim::check_reference(*scene, *image, model, trace_float64(*scene, frame.width, frame.height));
  Json record = head(frame, "model", sim::Mode::kBvh);
  record["hits"] = check.hits;
  record["other_primitive"] = check.other_primitive;
  record["other_cell"] = check.other_cell;
  record["far_colour"] = check.far_colour;
  record["worst_colour"] = check.worst;
  return record;
}

Json embree_run(const Frame& frame) {
  constexpr int kTimes = 5;  // the fastest counts
  const auto scene = scene_of(frame);
  const Embree embree(*scene);
  Json record = head(frame, "embree", sim::Mode::kBvh);
  record["threads"] = 1;
  record["build_seconds"] = embree.build_seconds();
  EmbreeFrame seen;
  for (const int packet : {16, 8, 4, 1}) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kTimes; ++i) {
      seen = embree.frame(frame.width, frame.height, packet);
      best = std::min(best, seen.seconds);
    }
    record["rays_per_second"][std::to_string(packet)] = double(seen.prims.size()) / best;
  }
  const sim::Rendering model = sim::run_model(*image_of(frame));
  std::vector<int> ours;
  for (std::size_t i = 0; i < seen.prims.size(); ++i) ours.push_back(static_cast<int>(static_cast<std::int32_t>(model.hit(i).prim)));
  const auto found = disagreements(*scene, frame.width, frame.height, ours, seen.prims);
  const auto count = [&](auto&& f) { return std::ranges::count_if(found, f); };
  record["other_primitive"] = found.size();
  record["edges"] = count([](const Disagreement& d) { return d.cause == Cause::Edge; });
  record["ties"] = count([](const Disagreement& d) { return d.cause == Cause::Tie; });
  record["unexplained"] = count([](const Disagreement& d) { return d.cause == Cause::Unexplained; });
  record["float64_with_model"] = count([](const Disagreement& d) { return d.float64 == d.ours; });
  return record;
}

Json host_run(const Frame& frame, double field_of_view) {
  Scene scene = *scene_of(frame);
  if (field_of_view > 0) scene.camera.field_of_view = field_of_view;
  const SceneImage image = compile(scene, frame.width, frame.height);
  Json record = head(frame, "host", sim::Mode::kBrute);
  record["field_of_view"] = scene.camera.field_of_view;
  record["threads"] = 1;
  record["float64_seconds"] = seconds_of([&] { trace_float64(scene, frame.width, frame.height, 1); });
  record["float32_seconds"] = seconds_of([&] { trace_float32(scene, frame.width, frame.height, 1); });
  record["fixed_seconds"] = seconds_of([&] { sim::run_model(image, {.mode = sim::Mode::kBrute}, {}, 1); });
  return record;
}

}  // namespace castray::bench
