// SPDX-License-Identifier: Apache-2.0
#include "scene/files.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "scene/scene.hpp"

namespace castray {

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw SceneError(path.string(), "open", "no such file");
  if (std::filesystem::is_directory(status)) throw SceneError(path.string(), "open", "is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw SceneError(path.string(), "open", std::strerror(errno));
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (in.bad()) throw SceneError(path.string(), "read", std::strerror(errno));
  return std::move(bytes).str();
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
