// SPDX-License-Identifier: Apache-2.0
// What the tests of the host side share.
#pragma once
#include <fstream>

#include "folder_test.hpp"
#include "scene/load.hpp"

namespace castray::tb {

class SceneTest : public FolderTest {
 protected:
  std::filesystem::path put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  // The message of the error that f throws, with the test's folder left out of it.
  template <class F> std::string error_of(F&& f) const {
    try {
      f();
    } catch (const SceneError& error) {
      std::string text = error.what();
      EXPECT_EQ(text.find('\n'), std::string::npos) << "more than one line: " << text;
      for (std::size_t at; (at = text.find(folder_.string() + "/")) != std::string::npos;) text.erase(at, folder_.string().size() + 1);
      return text;
    }
    return "no error";
  }
  std::string load_error(const std::string& name, const std::string& text) const {
    return error_of([&] { load_scene(put(name, text)); });
  }
};

// One triangle, in the plain layout.
inline const char* const kTriangleGeo = "1 3 0 1 2  0 0 0 1 0 0 0 1 0  0 0 1 0 0 1 0 0 1  0 0 1 0 0 1\n";

}  // namespace castray::tb
