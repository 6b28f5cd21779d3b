// SPDX-License-Identifier: Apache-2.0
// Whole files, in and out.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace castray {

// Throws SceneError when there is no such file, or it is a folder, or it may not be read.
void check_readable(const std::filesystem::path& path);

// Bytes that are read of a file: what has more, a device without end among it, is refused.
inline constexpr std::uint64_t kMostFileBytes = std::uint64_t{4} << 30;
std::string too_many_bytes(std::uint64_t most);  // the message

// The bytes of a file. Throws SceneError when the file cannot be read, or has more than so many.
std::string read_file(const std::filesystem::path& path, std::uint64_t most = kMostFileBytes);

// Written beside its place and then moved there: no partial file is left. Throws SceneError.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace castray
