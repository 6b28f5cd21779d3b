// SPDX-License-Identifier: Apache-2.0
#include "scene/files.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "scene/scene.hpp"

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
  std::filesystem::path partial = path;
  partial += ".part";
  std::ofstream out(partial, std::ios::binary | std::ios::trunc);
  if (!out) throw SceneError(path.string(), "write", std::strerror(errno));
  out << bytes;
  out.close();
  std::error_code error;
  if (!out) {
    const std::string cause = std::strerror(errno);
    std::filesystem::remove(partial, error);
    throw SceneError(path.string(), "write", cause);
  }
  std::filesystem::rename(partial, path, error);
  if (error) {
    const std::string cause = error.message();
    std::filesystem::remove(partial, error);
    throw SceneError(path.string(), "write", cause);
  }
}

}  // namespace castray
