// SPDX-License-Identifier: Apache-2.0
// A path named in the RTL, the model or the docs is a file of the tree, and a unit and its model of
// the same name name each other.
#include <gtest/gtest.h>

#include <filesystem>

#include "doc_tables.hpp"

namespace castray::tb {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_under(const fs::path& folder, const std::string& suffix) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == suffix) files.push_back(entry.path());
  EXPECT_FALSE(files.empty()) << folder;
  return files;
}

std::vector<std::string> paths_named_in(const std::string& text) {
  static const std::regex path("\\b(?:rtl|cpp_model|sim|tb|tools|docs|scenes)/[a-z0-9_/.-]*\\.(?:sv|[ch]pp|md|mk|json|geo|py|sh|sha256|vlt|f)\\b");
  std::vector<std::string> paths;
  for (std::sregex_iterator it(text.begin(), text.end(), path), end; it != end; ++it) paths.push_back(it->str());
  return paths;
}

TEST(Paths, FindsThemInText) {
  EXPECT_EQ(paths_named_in("see rtl/a/b.sv, and `cpp_model/core.cpp` (cast); not cpp_model/ or tb/FOLDER/NAME_test.cpp"),
            (std::vector<std::string>{"rtl/a/b.sv", "cpp_model/core.cpp"}));
}

TEST(Paths, WhatIsNamedExists) {
  std::vector<fs::path> files = files_under("docs", ".md");
  files.push_back("README.md");
  for (const auto& [folder, suffix] : {std::pair{"rtl", ".sv"}, {"cpp_model", ".hpp"}, {"cpp_model", ".cpp"}})
    for (const fs::path& file : files_under(folder, suffix)) files.push_back(file);
  for (const fs::path& file : files) {
    if (file == "docs/add-a-unit.md") continue;  // adds a unit that the tree does not have
    for (const std::string& path : paths_named_in(file_text(file))) EXPECT_TRUE(fs::exists(path)) << file << " names " << path;
  }
}

TEST(Paths, AUnitAndItsModelNameEachOther) {
  std::size_t pairs = 0;
  for (const fs::path& unit : files_under("rtl", ".sv")) {
    const std::string model = "cpp_model" + unit.string().substr(3, unit.string().size() - 6) + ".hpp";
    if (!fs::exists(model)) continue;
    ++pairs;
    EXPECT_NE(file_text(unit).find(model), std::string::npos) << unit << " does not name its model";
    EXPECT_NE(file_text(model).find(unit.string()), std::string::npos) << model << " does not name the unit that it mirrors";
  }
  EXPECT_GT(pairs, 20u);
}

}  // namespace
}  // namespace castray::tb
