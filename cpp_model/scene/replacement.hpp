// SPDX-License-Identifier: Apache-2.0
// A file that is written beside its place and then moved there, so that what stands under its name is
// whole. A link is followed. What is no file, a pipe or a device, is written in its place.
#pragma once
#include <filesystem>
#include <system_error>

namespace castray {

// One name for each file, however it was written: absolute, links followed, whether it exists or not.
std::filesystem::path place_of(const std::filesystem::path& file);

class Replacement {
 public:
  explicit Replacement(const std::filesystem::path& file);
  ~Replacement();  // what was not committed is removed
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  const std::filesystem::path& name() const { return name_; }  // write here; the suffix is the file's
  std::error_code commit();

  // Whether the file could be written: none if so. Leaves nothing behind.
  static std::error_code check(const std::filesystem::path& file);

 private:
  std::filesystem::path file_;
  std::filesystem::path name_;
  bool in_place_;
  bool moved_ = false;
};

}  // namespace castray
