// SPDX-License-Identifier: Apache-2.0
#include "scene/files.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "scene/replacement.hpp"
#include "scene/scene_error.hpp"

namespace castray {

void check_readable(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw SceneError(path.string(), "open", "no such file");
  if (std::filesystem::is_directory(status)) throw SceneError(path.string(), "open", "is a folder");
  if (!std::ifstream(path, std::ios::binary)) throw SceneError(path.string(), "open", std::strerror(errno));
}

std::string read_file(const std::filesystem::path& path) {
  check_readable(path);
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::array<char, 1 << 16> part;  // not by its size: a pipe has none
  while (in.read(part.data(), part.size()), in.gcount() > 0) bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw SceneError(path.string(), "read", std::strerror(errno));
  return bytes;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  const auto check = [&](bool ok, int code) {
    if (!ok) throw SceneError(path.string(), "write", std::strerror(code));
  };
  const std::error_code unwritable = Replacement::check(path);
  check(!unwritable, unwritable.value());
  Replacement replacement(path);
  std::ofstream out(replacement.name(), std::ios::binary | std::ios::trunc);
  check(out.is_open(), errno);
  out << bytes;
  out.close();
  check(!out.fail(), errno);
  const std::error_code error = replacement.commit();
  check(!error, error.value());
}

}  // namespace castray
