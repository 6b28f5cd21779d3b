// SPDX-License-Identifier: Apache-2.0
// A test with a folder of its own, empty at its beginning and removed at its end.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace castray::tb {

class FolderTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("castray_test_" + std::to_string(getpid()));
};

}  // namespace castray::tb
