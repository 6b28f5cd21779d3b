// SPDX-License-Identifier: Apache-2.0
// Whole files, in and out.
#pragma once
#include <filesystem>
#include <string>

namespace castray {

// Throws SceneError when there is no such file, or it is a folder, or it may not be read.
void check_readable(const std::filesystem::path& path);

// The bytes of a file. Throws SceneError when the file cannot be read.
std::string read_file(const std::filesystem::path& path);

// Written beside its place and then moved there: no partial file is left. Throws SceneError.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace castray
