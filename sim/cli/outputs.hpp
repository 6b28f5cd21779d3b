// SPDX-License-Identifier: Apache-2.0
// The files that a command was asked to write, judged before any work is done.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace castray::cli {

struct Output {
  std::string option;          // as on the command line
  std::filesystem::path file;  // empty: not asked for
  std::function<void(const std::filesystem::path&)> check;  // throws when the file cannot be written
};

// A file that is read beside the scene: what it is, and where.
struct Input {
  std::string what;
  std::filesystem::path file;
};

// Throws InputError when two options name one file, or one names the scene's file, a mesh of it or another
// input; then whatever the checks throw.
void check_outputs(const std::vector<Output>& outputs, const Scene& scene, const std::vector<Input>& inputs = {});

// Whether it is where standard output goes: what is for people is not to be mixed with its bytes.
bool is_standard_output(const std::filesystem::path& file);

// Writes a file whole, or leaves none. Throws PictureError.
void write_output(const std::filesystem::path& file, const std::string& bytes);

}  // namespace castray::cli
