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

std::string too_many_bytes(std::uint64_t most) { return "more than " + std::to_string(most) + " bytes, the most that are read"; }

std::string read_file(const std::filesystem::path& path, std::uint64_t most) {
  check_readable(path);
  std::error_code none;
  if (const std::uint64_t size = std::filesystem::file_size(path, none); !none && size > most) throw SceneError(path.string(), "read", too_many_bytes(most));
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::array<char, 1 << 16> part;  // not by its size: a pipe has none
  while (in.read(part.data(), part.size()), in.gcount() > 0) {
    if (static_cast<std::uint64_t>(in.gcount()) > most - bytes.size()) throw SceneError(path.string(), "read", too_many_bytes(most));
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
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
