// SPDX-License-Identifier: Apache-2.0
#include "core_model.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

namespace castray::sim {
namespace {

std::string count(int n, const char* noun) { return std::to_string(n) + " " + noun + (n == 1 ? "" : "s"); }

// The folder `cores` beside this program, or beside one of the folders it lies in.
std::filesystem::path cores_folder() {
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (; folder.has_relative_path(); folder = folder.parent_path())
    if (std::filesystem::is_directory(folder / "cores")) return folder / "cores";
  throw std::invalid_argument("no folder build/cores: build a core first, for example with 'make build/cores/l3c32t3p2m128.so'");
}

}  // namespace

std::string CoreVariant::file(bool waves) const {
  return "l" + std::to_string(lanes) + "c" + std::to_string(contexts) + "t" + std::to_string(tile_log2) + "p" +
         std::to_string(ports) + "m" + std::to_string(l2_kbytes) + (waves ? "w.so" : ".so");
}

std::string text_of(const CoreVariant& variant) {
  const std::string side = std::to_string(1 << variant.tile_log2);
  return count(variant.lanes, "lane") + ", " + count(variant.contexts, "context") + " each, tiles of " + side + "x" + side + ", " +
         count(variant.ports, "port") + ", " + (variant.l2_kbytes ? "L2 of " + std::to_string(variant.l2_kbytes) + " KB" : "no L2");
}

std::unique_ptr<CoreModel> make_core(const CoreVariant& variant, std::uint64_t seed, bool waves, const std::string& cores) {
  std::filesystem::path file = (cores.empty() ? cores_folder() : std::filesystem::path(cores)) / variant.file(waves);
  if (waves && !std::filesystem::exists(file)) file.replace_filename(variant.file());
  if (!std::filesystem::exists(file))
    throw std::invalid_argument("no core of " + text_of(variant) + " was built: make build/cores/" + variant.file(waves));
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays loaded
  if (!library) throw std::runtime_error(dlerror());
  const auto factory = reinterpret_cast<CoreFactory>(dlsym(library, kCoreFactory));
  if (!factory) throw std::runtime_error(dlerror());
  std::unique_ptr<CoreModel> core(factory(seed));
  if (waves && !core->has_waves())
    throw std::invalid_argument("the core of " + text_of(variant) + " was built without waveforms: make build/cores/" + variant.file(true));
  return core;
}

}  // namespace castray::sim
