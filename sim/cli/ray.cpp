// SPDX-License-Identifier: Apache-2.0
// castray ray: one ray, stage by stage, the model's values beside the RTL's.
#include <algorithm>
#include <cstdio>

#include "arguments.hpp"
#include "driver.hpp"
#include "model_device.hpp"
#include "outputs.hpp"
#include "picture.hpp"
#include "probe.hpp"
#include "ray_sheet.hpp"
#include "ray_trace.hpp"
#include "reference/float64.hpp"
#include "scene/compile.hpp"
#include "summary.hpp"

namespace castray::cli {
namespace {

struct Arguments {
  SceneArguments scene;
  CoreArguments core;
  int x = 0;
  int y = 0;
  std::string trace;
  int limit = 20;
};

// What the buffers of either device hold.
std::vector<shaded_t> pixel_at(const sim::Rendering& rendering, const pixel_tag_t& tag) {
  shaded_t pixel;
  pixel.tag = tag;
  pixel.colour = rendering.pixels[rendering.index(static_cast<int>(tag.x), static_cast<int>(tag.y))];
  return {pixel};
}
std::vector<hit_record_t> record_at(const sim::Rendering& rendering, const pixel_tag_t& tag) {
  return {rendering.hit(rendering.index(static_cast<int>(tag.x), static_cast<int>(tag.y)))};
}

// A triangle's result overtakes that of a sphere, whose root takes longer.
std::vector<result_t> triangles_first(std::vector<result_t> results) {
  std::stable_partition(results.begin(), results.end(), [](const result_t& result) { return result.kind == KindTriangle; });
  return results;
}

ExitCode ray(const Arguments& args, const sim::RunRtl& run_rtl) {
  const Scene scene = args.scene.load();
  if (args.x < 0 || args.x >= scene.width || args.y < 0 || args.y >= scene.height)
    throw InputError("pixel (" + std::to_string(args.x) + ", " + std::to_string(args.y) + ") is outside the frame of " +
                     std::to_string(scene.width) + "x" + std::to_string(scene.height));
  check_outputs({{"--trace", args.trace, sim::check_writable}}, scene);
  sim::make_core(args.core.options().variant, 0, !args.trace.empty());  // is it built?
  const SceneImage image = compile(scene, scene.width, scene.height);
  args.scene.print_notes(scene);
  const sim::RenderOptions options = args.core.replay(scene, args.x, args.y);
  sim::RtlOptions device = args.core.options();
  const int tile_log2 = device.variant.tile_log2;

  sim::ModelDevice model(0, tile_log2);
  sim::Driver model_driver(model);
  model_driver.load(image);
  const sim::Rendering expected = model_driver.render(options);
  if (expected.error != ErrNone) {
    std::fprintf(stderr, "castray: the model refuses the job: %s\n", meaning(expected.error));
    return kDeviceError;
  }
  const RayTrace trace = trace_pixel(model.job(), model.windows(model.job()), args.x, args.y, tile_log2);

  device.trace_file = args.trace;
  sim::Probe probe(args.x, args.y, options.mode == sim::Mode::kBvh);
  const sim::Probe::Attached attached(probe);
  const sim::RtlRun rtl = run_rtl(image, device, options, {});
  const sim::Rendering& rendering = rtl.rendering;

  std::printf("%s, pixel (%d, %d) of %dx%d, mode %s: %s\n\n  %-18s %26s %26s\n", args.scene.file.c_str(), args.x, args.y, scene.width,
              scene.height, args.core.mode.c_str(), rtl.device.c_str(), "", "model", "rtl");
  RaySheet sheet(args.limit);
  sheet.stage("bounds of the tile's rays (tile_bounds)", trace.bounds, probe.bounds);
  sheet.stage("nodes read to start the tile (frontier)", trace.reads, probe.reads);
  sheet.stage("parts of the scene that the tile may meet (tile_node)", trace.frontier, probe.frontier);
  sheet.stage("start of the tile (tile_start)", trace.started, probe.started);
  sheet.stage("direction (ray_gen)", trace.directions, probe.directions);
  sheet.stage("ray (ray_setup)", trace.rays, probe.rays);
  sheet.stage("nodes and leaves in order (step, node_visits)", trace.visits, probe.visits);
  sheet.stage("tests (prim_tests)", trace.tests, probe.tests);
  sheet.stage("accepted primitives (ray_prim)", trace.candidates, probe.candidates);
  sheet.stage("distances (hit_unit)", triangles_first(trace.results), triangles_first(probe.results));
  sheet.stage("nearest hit (lane)", std::vector{trace.hit}, probe.hits);
  sheet.stage("pixel (shade)", std::vector{trace.shaded}, probe.shaded);
  sheet.stage("frame buffer", pixel_at(expected, trace.tag), pixel_at(rendering, trace.tag));
  sheet.stage("hit record", record_at(expected, trace.tag), record_at(rendering, trace.tag));

  const ReferencePixel reference = trace_float64(scene, scene.width, scene.height, args.x, args.y);
  std::printf("\nfloat64: primitive %d, distance %.9g (model %.9g), u %.9g, v %.9g, colour %d %d %d\n", reference.prim, reference.t,
              trace.hit.found ? scene_distance(image, args.x, args.y, trace.hit.t) : std::numeric_limits<double>::infinity(),
              reference.u, reference.v, reference.colour[0], reference.colour[1], reference.colour[2]);
  if (rendering.error != ErrNone) {
    std::fprintf(stderr, "castray: the core stopped: %s\n", meaning(rendering.error));
    return kDeviceError;
  }
  std::printf("%zu values differ between model and RTL\n", sheet.differ());
  print_violations(rtl);
  if (sheet.differ() > 0) return kMismatch;
  return rtl.violations > 0 ? kBusRules : kOk;
}

}  // namespace

void add_ray(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("ray", "one ray stage by stage, the model beside the RTL");
  const auto args = std::make_shared<Arguments>();
  args->scene.add_to(*command);
  command->add_option("x", args->x, "column of the pixel, from the left")->required();
  command->add_option("y", args->y, "row of the pixel, from the top")->required();
  args->core.add_to(*command);
  command->add_option("--trace", args->trace, "waveforms (FST) of the run; a core with waveforms: make build/cores/l3c32t3p2m128w.so")
      ->check(output_name);
  command->add_option("--limit", args->limit, "items of a stage that are shown in full")->check(CLI::NonNegativeNumber)->capture_default_str();
  command->callback([args, &context] { context.code = ray(*args, context.run_rtl); });
}

}  // namespace castray::cli
