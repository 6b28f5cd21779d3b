// SPDX-License-Identifier: Apache-2.0
#include "scene/replacement.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <fstream>
#include <string>

namespace castray {

namespace fs = std::filesystem;

namespace {
constexpr int kMostLinks = 40;  // as the kernel follows

// The name to write under, no longer than a name may be: a long one loses the end of its stem, or of its suffix.
std::string part_of(const fs::path& file) {
  if (file.filename().native().size() > NAME_MAX) return file.filename();  // cannot be opened either
  const std::string part = ".part" + std::to_string(getpid()), stem = file.stem().string();
  const std::string suffix = file.extension().string().substr(0, NAME_MAX - 1 - part.size());
  std::size_t kept = std::min(stem.size(), NAME_MAX - 1 - part.size() - suffix.size());
  while (kept < stem.size() && kept > 0 && (stem[kept] & 0xc0) == 0x80) --kept;  // not within a character
  return "." + stem.substr(0, kept) + part + suffix;
}
}  // namespace

fs::path place_of(const fs::path& file) {
  fs::path place = file;
  std::error_code error;
  // By hand: to the library a link to what does not exist yet is no link.
  for (int i = 0; i < kMostLinks && fs::is_symlink(place, error); ++i) place = place.parent_path() / fs::read_symlink(place, error);
  const fs::path canonical = fs::weakly_canonical(fs::absolute(place, error), error);
  return error ? file : canonical;
}

Replacement::Replacement(const fs::path& file) : file_(file), name_(file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  in_place_ = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  if (in_place_) return;
  name_ = file_ = place_of(file);
  name_.replace_filename(part_of(file_));
}

Replacement::~Replacement() {
  std::error_code ignored;
  if (!in_place_ && !moved_) fs::remove(name_, ignored);
}

std::error_code Replacement::commit() {
  std::error_code error;
  if (!in_place_) fs::rename(name_, file_, error);
  moved_ = !error;
  return error;
}

std::error_code Replacement::check(const fs::path& file) {
  std::error_code ignored;
  if (file.filename().empty() || fs::is_directory(file, ignored)) return std::make_error_code(std::errc::is_a_directory);
  const Replacement replacement(file);
  errno = 0;
  const bool writable = replacement.in_place_ ? access(file.c_str(), W_OK) == 0 : std::ofstream(replacement.name()).is_open();
  return writable ? std::error_code() : std::error_code(errno, std::generic_category());
}

}  // namespace castray
