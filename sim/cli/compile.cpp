// SPDX-License-Identifier: Apache-2.0
// castray compile: the scene image as a file, for whoever drives a core without the host's code.
#include <cstdio>

#include "arguments.hpp"
#include "outputs.hpp"
#include "picture.hpp"
#include "scene/compile.hpp"
#include "summary.hpp"

namespace castray::cli {
namespace {

struct Arguments {
  SceneArguments scene;
  std::string output;
};

void compile_to(const Arguments& args) {
  if (args.output.empty()) throw InputError("--output: the name is empty");
  const Scene scene = args.scene.load();
  check_outputs({{"--output", args.output, sim::check_writable}}, scene);
  const SceneImage image = compile(scene, scene.width, scene.height);
  args.scene.print_notes(scene);
  for (const std::string& line : image.warnings) std::fprintf(stderr, "%s: warning: %s\n", args.scene.file.c_str(), line.c_str());
  std::FILE* const people = is_standard_output(args.output) ? stderr : stdout;
  write_output(args.output, std::string(image.bytes.begin(), image.bytes.end()));
  std::fprintf(people, "wrote %s: %s bytes, a frame of %dx%d\n", args.output.c_str(), grouped(image.bytes.size()).c_str(), scene.width, scene.height);
}

}  // namespace

void add_compile(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("compile", "a scene as the image that the core reads");
  const auto args = std::make_shared<Arguments>();
  args->scene.add_to(*command);
  command->add_option("-o,--output", args->output, "the scene image (docs/scene-image.md)")->required();
  command->callback([args, &context] {
    compile_to(*args);
    context.code = kOk;
  });
}

}  // namespace castray::cli
