// SPDX-License-Identifier: Apache-2.0
#include "uio/uio_node.hpp"

#include <algorithm>
#include <vector>

#include "castray_records.hpp"
#include "device.hpp"
#include "uio/uio_registers.hpp"

namespace castray::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWhatToDo = "load the bitstream and the device tree's node of the core, as docs/uio.md says";

// Nothing answers on the bus of an empty logic, and an access to it never ends.
void check_bitstream(const KernelRoots& roots) {
  const fs::path state = roots.sys / "class/fpga_manager/fpga0/state";
  if (!fs::exists(state)) return;
  if (const std::string text = read_attribute(state); text != "operating")
    throw DeviceError("the programmable logic holds no bitstream (" + state.string() + ": " + text + "): " + kWhatToDo);
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, error)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

fs::path entry_by_name(const fs::path& folder, const std::string& wanted) {
  std::vector<fs::path> found;
  std::string others;
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = read_attribute(entry / "name");
    if (name.starts_with(wanted)) found.push_back(entry);
    else others += (others.empty() ? "; there are: " : ", ") + name;
  }
  if (found.size() == 1) return found.front();
  if (found.empty())
    throw DeviceError("no board: no device named '" + wanted + "' under " + folder.string() + others + "; " + kWhatToDo);
  std::string names;
  for (const fs::path& entry : found) names += (names.empty() ? "" : ", ") + entry.filename().string();
  throw DeviceError("several devices are named '" + wanted + "' (" + names + "): choose one with --uio /dev/uioN");
}

}  // namespace

UioNode find_uio(const KernelRoots& roots, const std::string& wanted) {
  const fs::path folder = roots.sys / "class/uio";
  if (!fs::is_directory(folder))
    throw DeviceError("no board: this system has no " + folder.string() + "; on the board " + kWhatToDo +
                      "; elsewhere use --engine rtl or model");
  check_bitstream(roots);
  const bool by_path = wanted.find('/') != std::string::npos;
  const fs::path entry = by_path ? folder / fs::path(wanted).filename() : entry_by_name(folder, wanted);
  if (!fs::is_directory(entry))
    throw DeviceError("no board: " + wanted + " is not among the devices under " + folder.string() + "; " + kWhatToDo);
  UioNode node{by_path ? fs::path(wanted) : roots.dev / entry.filename(), read_attribute(entry / "name")};
  const fs::path map = entry / "maps/map0";
  if (fs::exists(map / "offset")) node.offset = read_number(map / "offset");
  const std::uint64_t size = read_number(map / "size");
  if (size < node.offset + kRegisterBytes)
    throw DeviceError(node.file.string() + ": maps " + std::to_string(size) + " bytes, a core's registers take " +
                      std::to_string(kRegisterBytes) + ": not this core's node");
  return node;
}

}  // namespace castray::sim
