// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <bit>
#include <cstdio>
#include <string_view>

#include "scene/load.hpp"

namespace castray::cli {
namespace {

// "320x240", each 1 to MaxFrameSize.
void parse_size(const std::string& text, int& width, int& height) {
  int end = 0;
  const bool two = std::sscanf(text.c_str(), "%6dx%6d%n", &width, &height, &end) == 2;
  if (!two || static_cast<std::size_t>(end) != text.size())
    throw InputError("--size " + text + ": not of the form WIDTHxHEIGHT");
  if (width < 1 || width > MaxFrameSize || height < 1 || height > MaxFrameSize)
    throw InputError("--size " + text + ": width and height must be 1 to " + std::to_string(MaxFrameSize));
}

}  // namespace

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:=+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

void SceneArguments::add_to(CLI::App& command) {
  command.add_option("scene", file, "a scene file (.json) or a mesh (.geo .obj .ply .stl .gltf .glb)")->required();
  command.add_option("--size", size, "the frame, WIDTHxHEIGHT; else the scene's own");
}

Scene SceneArguments::load() const {
  Scene scene = load_scene(file);
  if (!size.empty()) parse_size(size, scene.width, scene.height);
  for (const std::string& line : scene.warnings) std::fprintf(stderr, "%s: warning: %s\n", file.c_str(), line.c_str());
  for (const std::string& line : scene.defaults) std::fprintf(stderr, "%s: default: %s\n", file.c_str(), line.c_str());
  return scene;
}

void CoreArguments::add_to(CLI::App& command) {
  command.add_option("--lanes", lanes, "lanes of the core")->capture_default_str();
  command.add_option("--contexts", contexts, "rays in flight in each lane")->capture_default_str();
  command.add_option("--tile", tile, "side of a tile in pixels")->check(CLI::IsMember({4, 8, 16}))->capture_default_str();
  command.add_option("--ports", ports, "memory ports of the core")->check(CLI::IsMember({1, 2}))->capture_default_str();
  command.add_option("--l2", l2_kbytes, "KB of the shared cache; 0: none")->capture_default_str();
  command.add_option("--memory", memory, "timing of the memory: reference, or hp with 8 requests outstanding")
      ->check(CLI::IsMember({"reference", "hp"}))->capture_default_str();
  command.add_option("--stalls", stalls, "pattern of stalls on the five channels of the memory")
      ->check(CLI::IsMember(sim::Stalls::names()))->capture_default_str();
  command.add_flag("--reorder", reorder, "responses of different IDs overtake each other");
  command.add_option("--seed", seed, "of stalls, order and registers without reset")->capture_default_str();
}

sim::RtlOptions CoreArguments::options() const {
  sim::RtlOptions options;
  options.variant = {lanes, contexts, static_cast<int>(std::bit_width(static_cast<unsigned>(tile))) - 1, ports, l2_kbytes};
  options.timing = sim::AxiTiming::named(memory);
  options.timing.reorder = reorder;
  options.stalls = stalls;
  options.seed = seed;
  return options;
}

std::string CoreArguments::text() const {
  const CoreArguments none;
  std::string text;
  if (lanes != none.lanes) text += " --lanes " + std::to_string(lanes);
  if (contexts != none.contexts) text += " --contexts " + std::to_string(contexts);
  if (tile != none.tile) text += " --tile " + std::to_string(tile);
  if (ports != none.ports) text += " --ports " + std::to_string(ports);
  if (l2_kbytes != none.l2_kbytes) text += " --l2 " + std::to_string(l2_kbytes);
  if (memory != none.memory) text += " --memory " + memory;
  if (stalls != none.stalls) text += " --stalls " + stalls;
  if (reorder) text += " --reorder";
  if (seed != none.seed) text += " --seed " + std::to_string(seed);
  return text;
}

}  // namespace castray::cli
