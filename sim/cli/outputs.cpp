// SPDX-License-Identifier: Apache-2.0
#include "outputs.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <map>

#include "command.hpp"
#include "picture.hpp"
#include "scene/files.hpp"
#include "scene/replacement.hpp"

namespace castray::cli {
namespace {

namespace fs = std::filesystem;

bool is_stream(const fs::path& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

void check_outputs(const std::vector<Output>& outputs, const Scene& scene, const std::vector<Input>& inputs) {
  std::map<fs::path, std::string> taken{{place_of(scene.file), "the scene's file"}};
  for (const MeshSource& mesh : scene.meshes) taken.emplace(place_of(mesh.file), "a mesh of the scene");
  for (const Input& input : inputs) taken.emplace(place_of(input.file), input.what);
  for (const Output& output : outputs) {
    if (output.file.empty() || is_stream(output.file)) continue;
    const auto [other, is_new] = taken.emplace(place_of(output.file), "the file of " + output.option);
    if (!is_new) throw InputError(output.option + " " + output.file.string() + ": is " + other->second + " as well");
  }
  for (const Output& output : outputs)
    if (!output.file.empty()) output.check(output.file);
}

bool is_standard_output(const fs::path& file) {
  struct stat named, standard;
  return stat(file.c_str(), &named) == 0 && fstat(STDOUT_FILENO, &standard) == 0 && named.st_dev == standard.st_dev && named.st_ino == standard.st_ino;
}

void write_output(const fs::path& file, const std::string& bytes) {
  try {
    write_file(file, bytes);
  } catch (const SceneError& e) {
    throw sim::PictureError(e.what());
  }
}

}  // namespace castray::cli
