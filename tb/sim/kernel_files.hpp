// SPDX-License-Identifier: Apache-2.0
// What the kernel of a board shows of the core, as plain files in a folder of the test's own.
#pragma once
#include <fstream>
#include <iterator>
#include <string>

#include "folder_test.hpp"
#include "uio/open_board.hpp"

namespace castray::tb {

class KernelFiles {
 public:
  static constexpr std::uint64_t kAddress = 0x5'4320'0000;  // of the buffer
  static constexpr std::uint64_t kBytes = 2 << 20;

  explicit KernelFiles(const std::filesystem::path& folder, std::uint64_t buffer_bytes = kBytes) : roots{folder / "sys", folder / "dev"} {
    namespace fs = std::filesystem;
    fs::create_directories(roots.dev);
    add_uio("uio0", "castray@a0000000");
    fs::create_directories(buffer());
    put(buffer() / "phys_addr", "0x0000000543200000\n");
    put(buffer() / "size", std::to_string(buffer_bytes) + "\n");
    for (const char* name : {"sync_offset", "sync_size", "sync_direction", "sync_for_cpu", "sync_for_device"}) put(buffer() / name, "0\n");
    put(roots.dev / "udmabuf0", "");
    fs::resize_file(roots.dev / "udmabuf0", buffer_bytes);
  }

  void add_uio(const std::string& file, const std::string& name, const std::string& size = "0x0000000000001000") const {
    const auto map = uio() / file / "maps/map0";
    std::filesystem::create_directories(map);
    put(uio() / file / "name", name + "\n");
    put(map / "size", size + "\n");
    put(map / "offset", "0x0\n");
    put(roots.dev / file, std::string(4096, '\0'));
  }

  std::filesystem::path uio() const { return roots.sys / "class/uio"; }
  std::filesystem::path buffer() const { return roots.sys / "class/u-dma-buf/udmabuf0"; }
  static void put(const std::filesystem::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
  static std::string text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  sim::BoardOptions options() const {
    sim::BoardOptions options;
    options.roots = roots;
    return options;
  }

  const sim::KernelRoots roots;
};

}  // namespace castray::tb
