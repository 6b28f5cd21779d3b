// SPDX-License-Identifier: Apache-2.0
// Files of the kernel: attributes under /sys, device nodes under /dev. All functions throw DeviceError with one line
// that names the file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace castray::sim {

// Where the kernel shows its devices.
struct KernelRoots {
  std::filesystem::path sys = "/sys";
  std::filesystem::path dev = "/dev";
};

// The text of an attribute, without the end of its line; a number of it, decimal or 0x.
std::string read_attribute(const std::filesystem::path& file);
std::uint64_t read_number(const std::filesystem::path& file);
void write_attribute(const std::filesystem::path& file, const std::string& text);

// An open file, closed at its end.
class OpenFile {
 public:
  OpenFile(const std::filesystem::path& file, int flags);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

// Bytes of an open file, shared with whoever else maps them.
class Mapping {
 public:
  // offset is a multiple of a page.
  Mapping(const OpenFile& file, const std::filesystem::path& name, std::uint64_t offset, std::uint64_t bytes);
  ~Mapping();
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::uint8_t* data() const { return data_; }

 private:
  std::uint8_t* data_;
  std::uint64_t bytes_;
};

}  // namespace castray::sim
