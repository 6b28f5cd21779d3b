// SPDX-License-Identifier: Apache-2.0
#include "bench_runs.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "comparison.hpp"
#include "frame_run.hpp"
#include "reference/disagreement.hpp"
#include "reference/embree.hpp"
#include "reference/float32.hpp"
#include "reference/float64.hpp"
#include "reference_check.hpp"
#include "scene/load.hpp"

namespace castray::bench {
namespace {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Json head(const Frame& frame, const char* engine) {
  return {{"engine", engine},      {"scene", frame.scene},   {"view", frame.view}, {"mode", "brute"},
          {"width", frame.width}, {"height", frame.height}, {"pixels", frame.width * frame.height}};
}

Scene scene_of(const Frame& frame) { return load_scene("scenes/" + frame.file + ".json"); }

}  // namespace

Json rtl_run(const Frame& frame, const Core& core) {
  const SceneImage image = compile(scene_of(frame), frame.width, frame.height);
  sim::RtlOptions device;
  device.variant = {core.lanes, core.contexts, core.tile_log2};
  device.stalls = core.stalls;
  device.timing.reorder = core.stalls != "none";
  sim::RenderOptions options;
  options.hits = core.hits;
  options.mode = sim::Mode::kBrute;
  options.z_order = core.z_order;
  const sim::RtlRun run = sim::run_rtl(image, device, options);
  const sim::Rendering model = sim::run_model(image, options, {}, 1);
  const sim::Comparison comparison = sim::compare(run.rendering, model);
  const auto counter = [&](std::int64_t index) { return run.rendering.counters[static_cast<std::size_t>(index)]; };

  Json record = head(frame, "rtl");
  record["lanes"] = core.lanes;
  record["contexts"] = core.contexts;
  record["tile"] = 1 << core.tile_log2;
  record["walk"] = core.z_order ? "z" : "rows";
  record["ports"] = device.variant.ports;
  record["memory"] = device.timing.name;
  record["stalls"] = core.stalls == "none" ? Json() : Json(core.stalls);
  record["hit_buffer"] = core.hits;
  record["cycles"] = counter(CntCycles);
  record["pixels_differ"] = comparison.pixels_differ;
  record["hits_differ"] = comparison.hits_differ;
  record["error"] = static_cast<int>(run.rendering.error);
  record["rules_broken"] = run.violations;
  record["tests"] = counter(CntTests);
  record["hits"] = counter(CntHits);
  record["candidates"] = counter(CntCandidates);
  record["test_stalls"] = counter(CntTestStalls);
  record["fetch_stalls"] = counter(CntFetchStalls);
  record["attr_hits"] = counter(CntAttrHits);
  record["attr_misses"] = counter(CntAttrMisses);
  record["read_beats"] = counter(CntReadBeats);
  record["write_beats"] = counter(CntWriteBeats);
  record["cycles_per_second"] = run.cycles_per_second();
  if (core.stalls != "none")
    for (unsigned i = 0; i < sim::kChannels; ++i)
      if (run.shares[i].wanted > 0) record["blocked"][sim::kChannelNames[i]] = run.shares[i].share();
  return record;
}

Json reference_run(const Frame& frame) {
  const Scene scene = scene_of(frame);
  const SceneImage image = compile(scene, frame.width, frame.height);
  const sim::Rendering model = sim::run_model(image);
  const sim::ReferenceCheck check = sim::check_reference(scene, image, model, trace_float64(scene, frame.width, frame.height));
  Json record = head(frame, "model");
  record["hits"] = check.hits;
  record["other_primitive"] = check.other_primitive;
  record["other_cell"] = check.other_cell;
  record["far_colour"] = check.far_colour;
  record["worst_colour"] = check.worst;
  return record;
}

Json embree_run(const Frame& frame) {
  constexpr int kTimes = 5;  // the fastest counts
  const Scene scene = scene_of(frame);
  const Embree embree(scene);
  Json record = head(frame, "embree");
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
  const sim::Rendering model = sim::run_model(compile(scene, frame.width, frame.height));
  std::vector<int> ours;
  for (std::size_t i = 0; i < seen.prims.size(); ++i) ours.push_back(static_cast<int>(static_cast<std::int32_t>(model.hit(i).prim)));
  const auto found = disagreements(scene, frame.width, frame.height, ours, seen.prims);
  const auto count = [&](auto&& f) { return std::ranges::count_if(found, f); };
  record["other_primitive"] = found.size();
  record["edges"] = count([](const Disagreement& d) { return d.cause == Cause::Edge; });
  record["ties"] = count([](const Disagreement& d) { return d.cause == Cause::Tie; });
  record["unexplained"] = count([](const Disagreement& d) { return d.cause == Cause::Unexplained; });
  record["float64_with_model"] = count([](const Disagreement& d) { return d.float64 == d.ours; });
  return record;
}

Json host_run(const Frame& frame, double field_of_view) {
  Scene scene = scene_of(frame);
  if (field_of_view > 0) scene.camera.field_of_view = field_of_view;
  const SceneImage image = compile(scene, frame.width, frame.height);
  Json record = head(frame, "host");
  record["field_of_view"] = scene.camera.field_of_view;
  record["threads"] = 1;
  record["float64_seconds"] = seconds_of([&] { trace_float64(scene, frame.width, frame.height, 1); });
  record["float32_seconds"] = seconds_of([&] { trace_float32(scene, frame.width, frame.height, 1); });
  record["fixed_seconds"] = seconds_of([&] { sim::run_model(image, {.mode = sim::Mode::kBrute}, {}, 1); });
  return record;
}

}  // namespace castray::bench
