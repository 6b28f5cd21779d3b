// SPDX-License-Identifier: Apache-2.0
#include "uio/udmabuf.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "device.hpp"

namespace castray::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWhatToDo = "load the module u-dma-buf, as docs/uio.md says";

// The module's class is called so since its version 2, udmabuf before.
fs::path folder_of(const KernelRoots& roots, const std::string& name) {
  std::vector<fs::path> all;
  for (const char* kind : {"class/u-dma-buf", "class/udmabuf"}) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(roots.sys / kind, error)) all.push_back(entry.path());
  }
  std::sort(all.begin(), all.end());
  for (const fs::path& folder : all)
    if (name.empty() || folder.filename() == name) return folder;
  if (name.empty())
    throw DeviceError("no buffer: there is none under " + (roots.sys / "class/u-dma-buf").string() + "; " + kWhatToDo);
  throw DeviceError("no buffer named '" + name + "' under " + (roots.sys / "class/u-dma-buf").string() + "; " + kWhatToDo);
}

}  // namespace

Udmabuf::Udmabuf(const KernelRoots& roots, const std::string& name)
    : attributes_(folder_of(roots, name)),
      name_(attributes_.filename().string()),
      address_(read_number(attributes_ / "phys_addr")),
      bytes_(read_number(attributes_ / "size")),
      file_(roots.dev / name_, O_RDWR),
      mapping_(file_, roots.dev / name_, 0, bytes_) {}

void Udmabuf::write(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  std::memcpy(data() + offset, bytes.data(), bytes.size());
  hand_to(Owner::kDevice, offset, bytes.size());
}

void Udmabuf::read(std::uint64_t offset, std::span<std::uint8_t> bytes) {
  hand_to(Owner::kProcessor, offset, bytes.size());
  std::memcpy(bytes.data(), data() + offset, bytes.size());
}

void Udmabuf::hand_to(Owner owner, std::uint64_t offset, std::uint64_t bytes) {
  if (bytes == 0) return;
  const bool to_device = owner == Owner::kDevice;
  write_attribute(attributes_ / "sync_offset", std::to_string(offset));
  write_attribute(attributes_ / "sync_size", std::to_string(bytes));
  write_attribute(attributes_ / "sync_direction", to_device ? "1" : "2");  // DMA_TO_DEVICE, DMA_FROM_DEVICE
  write_attribute(attributes_ / (to_device ? "sync_for_device" : "sync_for_cpu"), "1");
}

}  // namespace castray::sim
