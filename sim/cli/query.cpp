// SPDX-License-Identifier: Apache-2.0
// castray query: the hits of a list of rays, on any engine.
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "arguments.hpp"
#include "board_run.hpp"
#include "castray_commit.hpp"
#include "comparison.hpp"
#include "mem/image.hpp"
#include "outputs.hpp"
#include "picture.hpp"
#include "progress_bar.hpp"
#include "query_csv.hpp"
#include "query_input.hpp"
#include "reference/ray_list.hpp"
#include "report.hpp"
#include "scene/files.hpp"
#include "scene/ray_record.hpp"
#include "scene/text.hpp"
#include "summary.hpp"

namespace castray::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStandard = "-";  // standard input, standard output

struct Arguments {
  SceneArguments scene;
  CoreArguments core;
  std::string rays;
  EngineArgument engine;
  BoardArguments board;
  std::string output = kStandard;
  std::string json, trace;
  bool raw = false;
  bool check = false;
  std::optional<std::size_t> only;

  Arguments() { core.mode = name_of(sim::Mode::kBvhRoot); }
  // A ray of a list has no tile: it starts at the root.
  sim::Mode mode() const { return core.render_mode() == sim::Mode::kBrute ? sim::Mode::kBrute : sim::Mode::kBvhRoot; }
  std::string name() const { return rays == kStandard ? "standard input" : rays; }
};

class Query {
 public:
  Query(const Arguments& arguments, const Context& context)
      : args_(arguments), context_(context), people_(args_.output == kStandard || is_standard_output(args_.output) ? stderr : stdout), scene_(args_.scene.load()) {}

  ExitCode run() {
    if (args_.output.empty()) throw InputError("--output: the name is empty; -: standard output");
    if (args_.check && !args_.engine.is_core()) throw InputError("--check: only --engine rtl or uio is compared with the model");
    if (args_.raw && !args_.engine.is_device()) throw InputError("--raw: only with --engine rtl, uio or model");
    if (!args_.trace.empty() && (args_.engine.name != "rtl" || !args_.only))
      throw InputError("--trace: only with --engine rtl and --only, for one ray");
    std::vector<Input> inputs;
    if (args_.rays != kStandard) inputs.push_back({"the file of rays", args_.rays});
    check_outputs({{"--output", args_.output == kStandard ? "" : args_.output, sim::check_writable},
                   {"--json", args_.json, sim::check_writable}, {"--trace", args_.trace, sim::check_writable}}, scene_, inputs);
    read_rays();
    if (args_.engine.name == "rtl") sim::make_core(args_.core.options().variant, 0, !args_.trace.empty());  // is it built?
    report_ = {{"scene", std::filesystem::path(args_.scene.file).stem().string()},
               {"engine", args_.engine.name},
               {"mode", name_of(args_.mode())},
               {"commit", kCommit},
               {"rays", count_}};
    const ExitCode code = args_.engine.is_device() ? on_device() : on_reference();
    if (!args_.json.empty()) write_json(args_.json, report_), wrote(args_.json);
    return code;
  }

 private:
  void read_rays() {
    const std::uint64_t most = args_.raw ? std::uint64_t{MaxRays} * RayBytes : kMostFileBytes;
    const std::string bytes = args_.rays == kStandard ? read_standard_input(most) : read_file(args_.rays, most);
    if (args_.raw) records_ = parse_records(args_.name(), bytes);
    else text_ = parse_rays(args_.name(), bytes, scene_.primitives());
    const std::size_t all = args_.raw ? records_.size() / RayBytes : text_.rays.size();
    if (args_.only && *args_.only >= all)
      throw InputError("--only " + std::to_string(*args_.only) + ": there are " + std::to_string(all) + " rays, from 0");
    first_ = args_.only.value_or(0);
    count_ = args_.only ? 1 : all;
  }

  // Raw records are on the grid of the scene's frame; else the grid holds every origin of the list.
  void make_records() {
    if (args_.raw) {
      image_ = compile(scene_, scene_.width, scene_.height);
    } else {
      image_ = compile_list();
      records_.resize(text_.rays.size() * RayBytes);
      for (std::size_t i = 0; i < text_.rays.size(); ++i)
        store_record(&records_[i * RayBytes], ray_record(image_, text_.rays[i]));
    }
    report_["grid_power"] = static_cast<int>(image_.header.grid_power);
  }

  SceneImage compile_list() const {
    try {
      return compile(scene_, text_.rays);
    } catch (const SceneError&) {
      compile(scene_, std::span<const ListRay>());  // an error of the scene itself
      throw InputError(place(farthest_origin(scene_, text_.rays)) +
                       ": the origin lies too far from the scene: nothing is left of it on a grid that holds both");
    }
  }

  std::span<const std::uint8_t> asked() const { return std::span(records_).subspan(first_ * RayBytes, count_ * RayBytes); }
  std::span<const ListRay> asked_rays() const { return std::span(text_.rays).subspan(first_, count_); }
  sim::QueryOptions options() const { return {.mode = args_.core.render_mode(), .steps = args_.core.steps}; }
  sim::Progress progress(ProgressBar& bar) const {
    return [&bar](double fraction, std::uint64_t cycles) { bar.show(fraction, cycles); };
  }

  // "rays.csv:12".
  std::string place(std::size_t ray) const {
    return args_.name() + (args_.raw ? ": record " + std::to_string(ray) : ":" + std::to_string(text_.lines[ray]));
  }

  // ---- RTL and model ----
  ExitCode on_device() {
    make_records();
    if (args_.engine.name != "uio") print_notes();
    ExitCode code = kOk;
    const sim::Answers answers = args_.engine.name == "rtl" ? on_rtl(code) : args_.engine.name == "uio" ? on_board() : on_model();
    if (answers.error != ErrNone) {
      std::fprintf(stderr, "castray: the core stopped with error %d: %s\n", static_cast<int>(answers.error),
                   meaning(answers.error));
      report_["error"] = static_cast<int>(answers.error);
      return kDeviceError;
    }
    if (args_.check && !equals_model(answers)) code = kMismatch;
    if (args_.raw) write(std::string(answers.hits.begin(), answers.hits.end()));
    else write(text_of(answers_of(answers)));
    return code;
  }

  void print_notes() const {
    args_.scene.print_notes(scene_);
    for (const std::string& line : image_.warnings)
      std::fprintf(stderr, "%s: warning: %s\n", args_.scene.file.c_str(), line.c_str());
  }

  void print_title(const std::string& device) const {
    std::fprintf(people_, "%s, %s of %s: %s\n", args_.scene.file.c_str(), counted(count_, "ray").c_str(), args_.name().c_str(),
                 device.c_str());
  }

  sim::Answers on_rtl(ExitCode& code) {
    sim::RtlOptions device = args_.core.options();
    device.trace_file = args_.trace;
    ProgressBar bar("tracing");
    const sim::RtlQuery run = context_.query_rtl(image_, asked(), device, options(), progress(bar));
    report_.update(report_of(run, run.answers.counters, device));
    print_title(run.device);
    print_work(run.answers.counters, run.seconds, people_);
    print_run(run, run.answers.counters, people_);
    if (!args_.trace.empty()) wrote(args_.trace);
    if (run.violations > 0) code = kBusRules;
    return run.answers;
  }

  sim::Answers on_board() {
    sim::Answers answers;
    ProgressBar bar("tracing");
    const BoardFacts facts = run_on_board(
        context_, args_.board, image_, [&](sim::Driver& driver) { answers = driver.query(asked(), options(), progress(bar)); });
    print_notes();  // behind the board's answer: a refusal is one line
    report_.update(report_of(answers.counters));
    report_["device"] = facts.device;
    report_["seconds"] = facts.seconds;
    print_title(facts.device);
    print_work(answers.counters, facts.seconds, people_);
    print_counters(answers.counters, people_);
    return answers;
  }

  sim::Answers on_model() {
    ProgressBar bar("tracing");
    const auto start = std::chrono::steady_clock::now();
    const sim::Answers answers = sim::query_model(image_, asked(), options(), progress(bar));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report_.update(report_of(answers.counters));
    report_["seconds"] = seconds;
    print_title("bit-accurate model");
    print_work(answers.counters, seconds, people_);
    return answers;
  }

  bool equals_model(const sim::Answers& answers) {
    ProgressBar bar("model");
    const sim::Answers expected = sim::query_model(image_, asked(), options(), progress(bar));
    const sim::Comparison comparison = sim::compare(answers, expected);
    const std::vector<std::string> counters = sim::counters_that_differ(answers.counters, expected.counters);
    report_["hits_differ"] = comparison.hits_differ;
    report_["counters_differ"] = counters.size();
    std::fprintf(people_, "  against the model: %s of %s hit records differ\n", grouped(comparison.hits_differ).c_str(),
                 grouped(count_).c_str());
    for (const std::string& line : counters) std::fprintf(people_, "  %s\n", line.c_str());
    for (const std::size_t i : comparison.first) explain(i, answers, expected);
    return comparison.hits_differ == 0 && counters.empty();
  }

  void explain(std::size_t i, const sim::Answers& answers, const sim::Answers& expected) const {
    const std::size_t ray = first_ + i;
    std::fprintf(people_,
                 "  ray %zu, %s\n    ray    %s\n    rtl    %s\n    model  %s\n    %s query %s %s --only %zu --check%s%s%s\n", ray,
                 place(ray).c_str(), to_text(load_record<ray_record_t>(&records_[ray * RayBytes])).c_str(),
                 to_text(answers.hit(i)).c_str(), to_text(expected.hit(i)).c_str(), shell_word(context_.program).c_str(),
                 shell_word(args_.scene.file).c_str(), shell_word(args_.rays).c_str(), ray, args_.raw ? " --raw" : "",
                 args_.scene.size ? (" --size " + *args_.scene.size).c_str() : "", args_.core.text().c_str());
  }

  std::vector<Answer> answers_of(const sim::Answers& answers) const {
    std::vector<Answer> list(answers.size());
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = answer_of(image_, asked_rays()[i], answers.hit(i));
    return list;
  }

  // ---- References ----
  ExitCode on_reference() {
    args_.scene.print_notes(scene_);
    const auto start = std::chrono::steady_clock::now();
    std::vector<ReferenceHit> hits;
    {
      ProgressBar bar("tracing");
      const auto share = [&](double fraction) { bar.show(fraction, 0); };
      hits = args_.engine.name == "float64" ? trace_list_float64(scene_, asked_rays(), 0, share)
                                            : trace_list_float32(scene_, asked_rays(), 0, share);
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::vector<Answer> answers(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) answers[i] = answer_of(asked_rays()[i], hits[i]);
    const auto found = static_cast<std::size_t>(std::ranges::count_if(answers, &Answer::hit));
    report_["hits"] = found;
    report_["seconds"] = seconds;
    print_title(args_.engine.name + " on this processor");
    std::fprintf(people_, "  hits %s\n  %.2f s\n", grouped(found).c_str(), seconds);
    write(text_of(answers));
    return kOk;
  }

  void write(const std::string& bytes) const {
    if (args_.output == kStandard) {
      std::fwrite(bytes.data(), 1, bytes.size(), stdout);
      return;
    }
    write_output(args_.output, bytes);
    wrote(args_.output);
  }
  void wrote(const std::string& file) const { std::fprintf(people_, "wrote %s\n", file.c_str()); }

  const Arguments& args_;
  const Context& context_;
  std::FILE* people_;  // where figures go: not among the answers
  Scene scene_;
  RayText text_;                       // unless raw
  std::vector<std::uint8_t> records_;  // of all rays
  std::size_t first_ = 0, count_ = 0;  // those that are asked
  SceneImage image_;
  Json report_;
};

}  // namespace

void add_query(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("query", "the hits of a list of rays");
  const auto args = std::make_shared<Arguments>();
  args->scene.add_to(*command);
  command
      ->add_option(
          "rays", args->rays,
          "lines of ox,oy,oz,dx,dy,dz, and if wanted tmin,tmax,any,cull,ignore, below a line with these names; -: standard input")
      ->required();
  args->engine.add_to(*command);
  args->core.add_to(*command);
  args->board.add_to(*command);
  command->add_option("-o,--output", args->output, "the answers; -: standard output")->capture_default_str();
  command->add_option("--json", args->json, "a report");
  command->add_flag("--raw", args->raw,
                    "rays are records of 64 bytes, on the grid of the scene's frame, and answers are hit records of 32");
  command->add_flag("--check", args->check, "compare every hit record with the model");
  command->add_option("--only", args->only, "only this ray, counted from 0, on the grid of all")
      ->check(whole_number);
  command->add_option("--trace", args->trace,
                      "waveforms (FST) of --only one ray; a core with waveforms: make build/cores/l3c32t3p2m128w.so");
  for (const char* const output : {"--json", "--trace"}) command->get_option(output)->check(output_name);
  command->callback([args, &context] { context.code = Query(*args, context).run(); });
}

}  // namespace castray::cli
