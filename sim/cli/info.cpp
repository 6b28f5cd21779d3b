// SPDX-License-Identifier: Apache-2.0
// castray info: what a scene holds, and what the core would be given of it.
#include <cmath>
#include <cstdio>

#include "arguments.hpp"
#include "scene/compile.hpp"
#include "scene/text.hpp"
#include "scene/tree_facts.hpp"
#include "summary.hpp"

namespace castray::cli {
namespace {

void info(const SceneArguments& arguments) {
  const Scene scene = arguments.load();
  const SceneImage image = compile(scene, scene.width, scene.height);
  arguments.print_notes(scene);
  const auto line = [](const char* name, const std::string& text) { std::printf("  %-14s %s\n", name, text.c_str()); };
  std::printf("%s\n", arguments.file.c_str());
  if (!scene.description.empty()) line("", scene.description);
  line("triangles", grouped(scene.triangles.size()));
  line("spheres", grouped(scene.spheres.size()));
  line("dropped", grouped(scene.dropped_triangles) + " degenerate triangles in the files, " + grouped(image.dropped_triangles) +
                      " on the grid, " + grouped(image.dropped_spheres) + " spheres");
  line("frame", std::to_string(scene.width) + "x" + std::to_string(scene.height));
  char text[160];
  const Vec3 eye = scene.camera.eye(), back = scene.camera.back();
  std::snprintf(text, sizeof text, "eye %g, %g, %g looking along %g, %g, %g, field of view %g degrees", eye.x, eye.y, eye.z,
                -back.x, -back.y, -back.z, scene.camera.field_of_view);
  line("camera", text);
  std::snprintf(text, sizeof text, "2^%d = %g scene units a step, from ", static_cast<int>(image.header.grid_power), image.step());
  const auto corner = [&](std::int64_t steps) { return text_of(static_cast<double>(steps) * image.step()); };
  line("grid", text + corner(image.header.corner_x) + ", " + corner(image.header.corner_y) + ", " + corner(image.header.corner_z));
  line("image", grouped(image.bytes.size()) + " bytes: " + grouped(image.header.lines.count) + " lines of primitives, " +
                    grouped(image.header.attributes.count) + " attributes");
  const TreeFacts tree = tree_facts(image);
  std::snprintf(text, sizeof text, "%s nodes of %.2f children in %u levels, %s leaves of %.2f primitives", grouped(tree.nodes).c_str(), tree.children,
                tree.depth, grouped(tree.leaves).c_str(), tree.occupancy);
  line("hierarchy", text);
  std::snprintf(text, sizeof text, "%.2f nodes, %.2f leaves, %.2f tests of a line through the scene's box", tree.nodes_met, tree.leaves_met, tree.tests_met);
  line("  heuristic", text);
  for (const std::string& warning : image.warnings) line("warning", warning);
}

}  // namespace

void add_info(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("info", "what a scene holds, and what the core would be given of it");
  const auto args = std::make_shared<SceneArguments>();
  args->add_to(*command);
  command->callback([args, &context] {
    info(*args);
    context.code = kOk;
  });
}

}  // namespace castray::cli
