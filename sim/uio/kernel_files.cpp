// SPDX-License-Identifier: Apache-2.0
#include "uio/kernel_files.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>

#include "device.hpp"

namespace castray::sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  const std::string hint = errno == EACCES || errno == EPERM ? " (run as root, or let your group in: docs/uio.md)" : "";
  throw DeviceError(file.string() + ": cannot be " + what + ": " + std::strerror(errno) + hint);
}

}  // namespace

std::string read_attribute(const fs::path& file) {
  std::ifstream in(file);
  if (!in) fail(file, "read");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

std::uint64_t read_number(const fs::path& file) {
  const std::string text = read_attribute(file);
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + (is_hex ? 2 : 0), end, number, is_hex ? 16 : 10);
  if (read.ec != std::errc() || read.ptr != end) throw DeviceError(file.string() + ": '" + text + "' is not a number");
  return number;
}

void write_attribute(const fs::path& file, const std::string& text) {
  const OpenFile out(file, O_WRONLY | O_TRUNC);
  if (::write(out.number(), text.data(), text.size()) != static_cast<ssize_t>(text.size())) fail(file, "written");
}

OpenFile::OpenFile(const fs::path& file, int flags) : number_(::open(file.c_str(), flags | O_CLOEXEC)) {
  if (number_ < 0) fail(file, "opened");
}
OpenFile::~OpenFile() { ::close(number_); }

Mapping::Mapping(const OpenFile& file, const fs::path& name, std::uint64_t offset, std::uint64_t bytes) : bytes_(bytes) {
  void* const data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), static_cast<off_t>(offset));
  if (data == MAP_FAILED) fail(name, "mapped");
  data_ = static_cast<std::uint8_t*>(data);
}
Mapping::~Mapping() { ::munmap(data_, bytes_); }

}  // namespace castray::sim
