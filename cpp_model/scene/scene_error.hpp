// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string>

namespace castray {

// Everything that is wrong with an input: what() is one line, "file: place: cause".
struct SceneError : std::runtime_error {
  SceneError(const std::string& file, const std::string& place, const std::string& cause)
      : std::runtime_error(file + ": " + place + ": " + cause) {}
};

}  // namespace castray
