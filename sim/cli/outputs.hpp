// SPDX-License-Identifier: Apache-2.0
// The files that a command was asked to write, judged before any work is done.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace castray::cli {

struct Output {
  std::string option;          // as on the command line
  std::filesystem::path file;  // empty: not asked for
  void (*check)(const std::filesystem::path&);  // throws when the file cannot be written
};

// Throws InputError when two options name one file, or one names the scene's file or a mesh of it;
// then whatever the checks throw.
void check_outputs(const std::vector<Output>& outputs, const Scene& scene);

}  // namespace castray::cli
