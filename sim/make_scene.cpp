// SPDX-License-Identifier: Apache-2.0
// Writes scenes of any size: make_scene teapot --n 40 -o build/teapot_100k.json
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "cli/exit_code.hpp"
#include "scene/files.hpp"
#include "scene/geo.hpp"
#include "scene/load.hpp"
#include "scene/made_scenes.hpp"
#include "scene/replacement.hpp"
#include "scene/text.hpp"

namespace {

using namespace castray;

void check_writable(const std::filesystem::path& file) {
  if (const std::error_code error = Replacement::check(file)) throw SceneError(file.string(), "write", error.message());
}

// The scene and its meshes; or the mesh alone, where the name asks for one. Throws SceneError, before anything is written
// if what is wrong can be seen then.
void write(const MadeScene& made, const std::filesystem::path& out) {
  const bool mesh_alone = out.extension() == ".geo";
  for (const auto& [file, mesh] : made.files) check_writable(file);
  if (!mesh_alone) check_writable(out);
  for (const auto& [file, mesh] : made.files) {
    write_file(file, geo_text(mesh));
    std::cout << file << ": " << mesh.points.size() << " points, " << mesh.face_sizes.size() << " faces\n";
  }
  if (!mesh_alone) save_scene(made.scene, out);
  std::cout << out.string() << ": " << made.scene.triangles.size() << " triangles, " << made.scene.spheres.size() << " spheres\n";
}

std::string stem(std::filesystem::path out) { return out.replace_extension().string(); }

int complain(cli::ExitCode code, const char* what) {
  std::cerr << "make_scene: " << one_line(what) << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes scenes of any size, as JSON and .geo beside it; the exit codes are those of castray");
  app.require_subcommand(1);
  std::string out;
  int n = 10, columns = 8, rows = 8, count = 4096;
  unsigned seed = 1;
  const auto add = [&](const char* name, const char* text) {
    CLI::App* command = app.add_subcommand(name, text);
    command->add_option("-o,--output", out, "file to write: .json")->required();
    return command;
  };
  const auto cells = [&](CLI::App* command) {
    command->add_option("--n", n, "cells of each patch along each side")->check(CLI::Range(1, 250))->capture_default_str();
  };
  CLI::App* teapot = add("teapot", "the Utah teapot from its 32 Bezier patches, base view; -o FILE.geo: the mesh alone");
  cells(teapot);
  CLI::App* field = add("field", "teapots in rows on a ground");
  cells(field);
  field->add_option("--columns", columns)->check(CLI::Range(1, 100))->capture_default_str();
  field->add_option("--rows", rows)->check(CLI::Range(1, 100))->capture_default_str();
  CLI::App* spheres = add("spheres", "spheres of many sizes in a cube");
  spheres->add_option("--count", count)->check(CLI::Range(1, 1'000'000))->capture_default_str();
  spheres->add_option("--seed", seed)->capture_default_str();
  try {
    app.parse(argc, argv);
    const MadeScene made = *teapot ? made_teapot(n, stem(out)) : *field ? made_field(columns, rows, n, stem(out)) : made_spheres(count, seed);
    write(made, out);
  } catch (const CLI::Success& e) {
    return app.exit(e);  // --help
  } catch (const CLI::ParseError& e) {
    return complain(cli::kBadInput, e.what());
  } catch (const SceneError& e) {
    return complain(cli::kBadOutput, e.what());
  } catch (const std::exception& e) {
    return complain(cli::kInternal, e.what());
  }
  return std::cout.flush() ? cli::kOk : complain(cli::kBadOutput, "standard output cannot be written");
}
