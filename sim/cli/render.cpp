// SPDX-License-Identifier: Apache-2.0
// castray render: a scene to a picture, on any engine.
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "arguments.hpp"
#include "board_run.hpp"
#include "castray_commit.hpp"
#include "comparison.hpp"
#include "frame_run.hpp"
#include "heat_map.hpp"
#include "outputs.hpp"
#include "picture.hpp"
#include "progress_bar.hpp"
#include "reference/float32.hpp"
#include "reference_check.hpp"
#include "report.hpp"
#include "scene/load.hpp"
#include "summary.hpp"

namespace castray::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Arguments {
  SceneArguments scene;
  CoreArguments core;
  EngineArgument engine;
  BoardArguments board;
  std::string output;
  std::string aov, json, frame, hits, save_scene;
  std::string nodes_map, tests_map;
  std::string trace, trace_window;
  bool check = false;
  bool float64 = false;
  bool z_order = false;

  bool work() const { return !nodes_map.empty() || !tests_map.empty(); }
};

class Render {
 public:
  Render(const Arguments& arguments, const Context& context) : args_(arguments), context_(context), scene_(args_.scene.load()) {}

  ExitCode run() {
    if (args_.check && !args_.engine.is_core()) throw InputError("--check: only --engine rtl or uio is compared with the model");
    if (!args_.engine.is_device() && (!args_.hits.empty() || !args_.frame.empty() || args_.float64 || args_.work()))
      throw InputError("--hits, --frame, --nodes-map, --tests-map, --against-float64: only with --engine rtl, uio or model");
    if (!args_.trace_window.empty() && args_.trace.empty()) throw InputError("--trace-window: needs --trace FILE");
    if (!args_.trace.empty() && args_.trace_window.empty() && !args_.check)
      throw InputError("--trace: needs --trace-window, or --check, whose first pixel that differs is traced");
    if (!args_.trace.empty() && args_.engine.name != "rtl") throw InputError("--trace: only --engine rtl has waveforms");
    if (output().extension().empty()) throw InputError("--output " + output().string() + ": the suffix says which format");
    const auto check_map = [this](const fs::path& file) { sim::check_heat_map(file, scene_.width, scene_.height); };
    const auto check_picture = [this](const fs::path& file) { sim::check_picture(file, scene_.width, scene_.height); };
    check_outputs({{"--output", output(), check_picture}, {"--aov", args_.aov, sim::check_aov},
                   {"--json", args_.json, sim::check_writable}, {"--frame", args_.frame, sim::check_writable},
                   {"--hits", args_.hits, sim::check_writable}, {"--nodes-map", args_.nodes_map, check_map},
                   {"--tests-map", args_.tests_map, check_map}, {"--save-scene", args_.save_scene, sim::check_writable},
                   {"--trace", args_.trace, sim::check_writable}}, scene_);
    if (args_.engine.name == "rtl") {  // whether the core is built, and with waveforms, is known before the frame
      sim::RtlOptions device = args_.core.options();
      if (!args_.trace_window.empty()) set_window(device);
      sim::make_core(device.variant, 0, !args_.trace.empty());
    }
    if (!args_.save_scene.empty()) save_scene(scene_, args_.save_scene);
    report_ = {{"scene", fs::path(args_.scene.file).stem().string()}, {"engine", args_.engine.name}, {"mode", args_.core.mode},
               {"commit", kCommit}, {"width", scene_.width}, {"height", scene_.height},
               {"pixels", static_cast<std::size_t>(scene_.width) * static_cast<std::size_t>(scene_.height)}};
    const ExitCode code = args_.engine.is_device() ? on_device() : on_reference();
    if (!args_.json.empty()) write_json(args_.json, report_), wrote(args_.json);
    return code;
  }

 private:
  fs::path output() const {
    return args_.output.empty() ? fs::path(fs::path(args_.scene.file).stem().string() + ".png") : fs::path(args_.output);
  }

  sim::Metadata metadata() const {
    sim::Metadata metadata{{"castray:scene", fs::path(args_.scene.file).filename().string()},
                           {"castray:engine", args_.engine.name}, {"castray:commit", kCommit}};
    if (args_.engine.name == "rtl") {
      metadata.emplace_back("castray:seed", std::to_string(args_.core.seed));
      metadata.emplace_back("castray:cycles", std::to_string(report_["cycles"].get<std::uint64_t>()));
    }
    return metadata;
  }

  // Without a use for the hit records a core is not asked for them: they cost it cycles.
  bool wants_hits() const { return args_.check || args_.float64 || !args_.aov.empty() || !args_.hits.empty() || args_.work(); }
  sim::RenderOptions options(bool hits) const {
    return {
        .hits = hits, .work = hits && args_.work(), .z_order = args_.z_order, .mode = args_.core.render_mode(), .steps = args_.core.steps};
  }

  sim::Progress progress(ProgressBar& bar) const {
    return [&bar](double fraction, std::uint64_t cycles) { bar.show(fraction, cycles); };
  }

  // ---- RTL and model ----
  ExitCode on_device() {
    image_ = compile(scene_, scene_.width, scene_.height);
    if (args_.engine.name != "uio") print_notes();
    ExitCode code = kOk;
    const sim::Rendering rendering = args_.engine.name == "rtl"   ? on_rtl(code)
                                     : args_.engine.name == "uio" ? on_board()
                                                                  : on_model();
    if (stopped(rendering)) return kDeviceError;
    if (args_.check && !equals_model(rendering)) code = kMismatch;
    if (args_.check && args_.core.render_mode() == sim::Mode::kBvh) {
      const sim::Rendering alone = again(code);
      if (stopped(alone)) return kDeviceError;
      if (!alone_equals_model(alone)) code = kMismatch;
    }
    if (args_.float64) against_float64(rendering);
    sim::write_picture(output(), sim::picture_of(rendering, scene_.pixel_format), metadata());
    wrote(output());
    if (!args_.aov.empty()) sim::write_aov(args_.aov, rendering, image_, metadata()), wrote(args_.aov);
    if (!args_.frame.empty()) write_raw(args_.frame, rendering.pixels.data(), rendering.pixels.size() * PixelBytes);
    if (!args_.hits.empty()) write_raw(args_.hits, rendering.hits.data(), rendering.hits.size());
    write_maps(rendering);
    return code;
  }

  bool stopped(const sim::Rendering& rendering) {
    if (rendering.error == ErrNone) return false;
    std::fprintf(stderr, "castray: the core stopped with error %d: %s\n", static_cast<int>(rendering.error), meaning(rendering.error));
    report_["error"] = static_cast<int>(rendering.error);
    return true;
  }

  void print_notes() const {
    args_.scene.print_notes(scene_);
    for (const std::string& line : image_.warnings)
      std::fprintf(stderr, "%s: warning: %s\n", args_.scene.file.c_str(), line.c_str());
  }

  void write_maps(const sim::Rendering& rendering) const {
    for (const bool tests : {false, true}) {
      const std::string& file = tests ? args_.tests_map : args_.nodes_map;
      if (file.empty()) continue;
      std::vector<std::uint32_t> values;
      for (std::size_t i = 0; i < rendering.pixels.size(); ++i) {
        const hit_record_t hit = rendering.hit(i);
        values.push_back(static_cast<std::uint32_t>(tests ? hit.tests : hit.nodes));
      }
      sim::write_heat_map(file, rendering.width, rendering.height, values, tests ? "tests a pixel" : "nodes a pixel", metadata());
      wrote(file);
    }
  }

  sim::Rendering on_rtl(ExitCode& code) {
    sim::RtlOptions device = args_.core.options();
    device.trace_file = args_.trace_window.empty() ? "" : args_.trace;
    if (!args_.trace_window.empty()) set_window(device);
    ProgressBar bar("rendering");
    const sim::RtlRun run = context_.run_rtl(image_, device, options(wants_hits()), progress(bar));
    report_.update(report_of(run, run.rendering.counters, device));
    std::printf("%s, %dx%d: %s\n", args_.scene.file.c_str(), scene_.width, scene_.height, run.device.c_str());
    print_work(run.rendering.counters, run.seconds);
    print_run(run, run.rendering.counters, stdout, with());
    if (run.violations > 0) code = kBusRules;
    return run.rendering;
  }

  sim::Rendering on_board() {
    sim::Rendering rendering;
    ProgressBar bar("rendering");
    const BoardFacts facts = run_on_board(context_, args_.board, image_, [&](sim::Driver& driver) {
      rendering = driver.render(options(wants_hits()), progress(bar));
    });
    print_notes();  // behind the board's answer: a refusal is one line
    report_.update(report_of(rendering.counters));
    report_["device"] = facts.device;
    report_["seconds"] = facts.seconds;
    std::printf("%s, %dx%d: %s\n", args_.scene.file.c_str(), scene_.width, scene_.height, facts.device.c_str());
    print_work(rendering.counters, facts.seconds);
    print_counters(rendering.counters, stdout, with());
    tile_log2_ = facts.tile_log2;
    return rendering;
  }
  const char* with() const { return wants_hits() ? ", the hit buffer written as well" : ""; }

  // The frame alone, on the same core: as a frame is rendered that nobody checks.
  sim::Rendering again(ExitCode& code) {
    ProgressBar bar("frame alone");
    if (args_.engine.name == "rtl") {
      const sim::RtlRun run = context_.run_rtl(image_, args_.core.options(), options(false), progress(bar));
      print_violations(run);
      if (run.violations > 0) code = kBusRules;
      return run.rendering;
    }
    sim::Rendering rendering;
    run_on_board(context_, args_.board, image_, [&](sim::Driver& driver) { rendering = driver.render(options(false), progress(bar)); });
    return rendering;
  }

  sim::Rendering on_model() {
    ProgressBar bar("rendering");
    const auto start = std::chrono::steady_clock::now();
    const sim::Rendering rendering = sim::run_model(image_, options(true), progress(bar), 0, tile_log2_);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report_.update(report_of(rendering.counters));
    report_["seconds"] = seconds;
    std::printf("%s, %dx%d: bit-accurate model\n", args_.scene.file.c_str(), scene_.width, scene_.height);
    print_work(rendering.counters, seconds);
    return rendering;
  }

  void set_window(sim::RtlOptions& device) const {
    const auto cycles = parse_pair(args_.trace_window, ':');
    if (!cycles || cycles->first >= cycles->second)
      throw InputError("--trace-window " + args_.trace_window + ": not of the form FIRST:LAST, in cycles");
    std::tie(device.trace_first, device.trace_last) = *cycles;
  }

  // ---- Comparisons ----
  bool equals_model(const sim::Rendering& rendering) {
    ProgressBar bar("model");
    const sim::Rendering expected = sim::run_model(image_, options(true), progress(bar), 0, tile_log2_);
    const sim::Comparison comparison = sim::compare(rendering, expected);
    const std::vector<std::string> counters = sim::counters_that_differ(rendering.counters, expected.counters);
    report_["pixels_differ"] = comparison.pixels_differ;
    report_["hits_differ"] = comparison.hits_differ;
    report_["counters_differ"] = counters.size();
    print_comparison(comparison, rendering);
    for (const std::string& line : counters) std::printf("  %s\n", line.c_str());
    for (const std::size_t i : comparison.first) explain(i, rendering, expected);
    if (!comparison.first.empty() && !args_.trace.empty() && args_.trace_window.empty()) trace_pixel(comparison.first[0]);
    return comparison.equal() && counters.empty();
  }

  // Without hit records tiles that no ray can hit are filled; with them they give their pixels.
  bool alone_equals_model(const sim::Rendering& rendering) {
    ProgressBar bar("model");
    const sim::Rendering expected = sim::run_model(image_, options(false), progress(bar), 0, tile_log2_);
    const sim::Comparison comparison = sim::compare(rendering, expected);
    const std::vector<std::string> counters = sim::counters_that_differ(rendering.counters, expected.counters);
    report_["frame_alone"] = {{"cycles", rendering.cycles()}, {"pixels_differ", comparison.pixels_differ}, {"counters_differ", counters.size()}};
    std::printf("  the frame alone: cycles %s; %s of %s pixels differ from the model\n", grouped(rendering.cycles()).c_str(),
                grouped(comparison.pixels_differ).c_str(), grouped(rendering.pixels.size()).c_str());
    for (const std::string& line : counters) std::printf("  %s\n", line.c_str());
    for (const std::size_t i : comparison.first) print_both(i, rendering, expected);
    return comparison.equal() && counters.empty();
  }

  void print_both(std::size_t i, const sim::Rendering& rendering, const sim::Rendering& expected) const {
    const auto width = static_cast<std::size_t>(scene_.width);
    std::printf("  (%zu, %zu)\n    rtl    %s\n    model  %s\n", i % width, i / width, sim::text_of(rendering, i).c_str(),
                sim::text_of(expected, i).c_str());
  }

  void explain(std::size_t i, const sim::Rendering& rendering, const sim::Rendering& expected) const {
    const auto width = static_cast<std::size_t>(scene_.width);
    print_both(i, rendering, expected);
    std::printf("    %s ray %s %zu %zu --size %dx%d%s\n", shell_word(context_.program).c_str(), shell_word(args_.scene.file).c_str(), i % width,
                i / width, scene_.width, scene_.height, args_.core.text().c_str());
  }

  // Renders the pixel again, with waveforms.
  void trace_pixel(std::size_t i) const {
    const int x = static_cast<int>(i) % scene_.width, y = static_cast<int>(i) / scene_.width;
    sim::RtlOptions device = args_.core.options();
    device.trace_file = args_.trace;
    context_.run_rtl(image_, device, args_.core.replay(scene_, x, y), {});
    std::printf("wrote %s, the waveforms of pixel (%d, %d)\n", args_.trace.c_str(), x, y);
  }

  void against_float64(const sim::Rendering& rendering) {
    ProgressBar bar("float64");
    const ReferenceFrame reference = trace_float64(scene_, scene_.width, scene_.height, 0, [&](int rows) {
      bar.show(static_cast<double>(rows) / scene_.height, 0);
    });
    const sim::ReferenceCheck check = sim::check_reference(scene_, image_, rendering, reference);
    print_reference(check);
    report_["float64"] = {{"other_primitive", check.other_primitive}, {"other_cell", check.other_cell},
                          {"far_colour", check.far_colour}, {"worst_channel", check.worst}};
  }

  // ---- References ----
  ExitCode on_reference() {
    args_.scene.print_notes(scene_);
    const auto start = std::chrono::steady_clock::now();
    ReferenceFrame frame;
    {
      ProgressBar bar("rendering");
      const auto rows = [&](int done) { bar.show(static_cast<double>(done) / scene_.height, 0); };
      frame = args_.engine.name == "float64" ? trace_float64(scene_, scene_.width, scene_.height, 0, rows)
                                        : trace_float32(scene_, scene_.width, scene_.height, 0, rows);
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report_["hits"] = frame.hits;
    report_["seconds"] = seconds;
    std::printf("%s, %dx%d: %s on this processor\n  hits %s\n  %.2f s\n", args_.scene.file.c_str(), scene_.width, scene_.height,
                args_.engine.name.c_str(), grouped(frame.hits).c_str(), seconds);
    sim::write_picture(output(), sim::picture_of(frame), metadata());
    wrote(output());
    if (!args_.aov.empty()) sim::write_aov(args_.aov, frame, metadata()), wrote(args_.aov);
    return kOk;
  }

  void write_raw(const std::string& file, const void* data, std::size_t bytes) const {
    write_output(file, std::string(static_cast<const char*>(data), bytes));
    wrote(file);
  }
  void wrote(const fs::path& file) const { std::printf("wrote %s\n", file.c_str()); }

  const Arguments& args_;
  const Context& context_;
  Scene scene_;
  SceneImage image_;
  int tile_log2_ = args_.core.options().variant.tile_log2;   // of the core
  Json report_;
};

}  // namespace

void add_render(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("render", "render a scene to a picture");
  const auto args = std::make_shared<Arguments>();
  args->scene.add_to(*command);
  args->engine.add_to(*command);
  args->core.add_to(*command);
  args->board.add_to(*command);
  command->add_option("-o,--output", args->output, "the picture; its suffix says which format; else SCENE.png here");
  command->add_option("--aov", args->aov, "EXR of the hits: raw records, and distances, u, v, primitives for people");
  command->add_option("--json", args->json, "a report");
  command->add_option("--frame", args->frame, "the raw words of the frame buffer");
  command->add_option("--hits", args->hits, "the raw hit records, 32 bytes a pixel");
  command->add_option("--nodes-map", args->nodes_map, "a heat map of the nodes that each pixel's ray visited");
  command->add_option("--tests-map", args->tests_map, "the same of its tests of primitives");
  command->add_option("--save-scene", args->save_scene, "the scene as JSON, all defaults filled in");
  command->add_flag("--check", args->check, "compare every pixel and every raw hit record with the model");
  command->add_flag("--against-float64", args->float64, "count the pixels that differ from the float64 reference");
  command->add_flag("--z-order", args->z_order, "walk the tiles along a Z curve, not in rows");
  command->add_option("--trace", args->trace,
                      "waveforms (FST): of --trace-window, or with --check of the first pixel that differs; "
                      "a core with waveforms: make build/cores/l3c32t3p2m128w.so");
  command->add_option("--trace-window", args->trace_window, "FIRST:LAST, cycles since power-up");
  for (const char* const output : {"--output", "--aov", "--json", "--frame", "--hits", "--nodes-map", "--tests-map", "--save-scene", "--trace"})
    command->get_option(output)->check(output_name);
  command->callback([args, &context] { context.code = Render(*args, context).run(); });
}

}  // namespace castray::cli
