// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdio>
#include <string_view>

#include "scene/limits.hpp"
#include "scene/load.hpp"
#include "scene/text.hpp"

namespace castray::cli {
namespace {

// "320x240".
FrameSize parse_size(const std::string& text) {
  const auto numbers = parse_pair(text, 'x');
  if (!numbers) throw InputError("--size " + text + ": not of the form WIDTHxHEIGHT");
  const auto [width, height] = *numbers;
  if (!kFrameSize.hold(static_cast<double>(width)) || !kFrameSize.hold(static_cast<double>(height)))
    throw InputError("--size " + text + ": width and height must be " + text_of(kFrameSize));
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

std::string whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole ? "" : "'" + text + "' is not a whole number from 0 to 2^64 - 1";
}

std::string output_name(const std::string& text) { return text.empty() ? "the name is empty" : ""; }

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:=+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> parse_pair(const std::string& text, char between) {
  std::pair<std::uint64_t, std::uint64_t> numbers;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, numbers.first);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != between) return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, numbers.second);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return numbers;
}

void SceneArguments::add_to(CLI::App& command) {
  command.add_option("scene", file, "a scene file (.json) or a mesh (.geo .obj .ply .stl .gltf .glb)")->required();
  command.add_option("--size", size, "the frame, WIDTHxHEIGHT; else the scene's own");
}

Scene SceneArguments::load() const {
  return load_scene(file, size ? std::optional(parse_size(*size)) : std::nullopt);
}

void SceneArguments::print_notes(const Scene& scene) const {
  for (const std::string& line : scene.warnings)
    std::fprintf(stderr, "%s: warning: %s\n", one_line(file).c_str(), one_line(line).c_str());
  for (const std::string& line : scene.defaults)
    std::fprintf(stderr, "%s: default: %s\n", one_line(file).c_str(), one_line(line).c_str());
}

void EngineArgument::add_to(CLI::App& command) {
  command
      .add_option("--engine", name,
                  "rtl: the simulated core; uio: that of this board; model: the bit-accurate model; float64, float32: references")
      ->check(CLI::IsMember({"rtl", "uio", "model", "float64", "float32"}))
      ->capture_default_str();
}

void CoreArguments::add_to(CLI::App& command) {
  command.add_option("--lanes", lanes, "lanes of the core")->check(CLI::Range(1, int{MaxLanes}))->capture_default_str();
  command.add_option("--contexts", contexts, "rays in flight in each lane")
      ->check(CLI::Range(1, 1 << CtxW))
      ->capture_default_str();
  command.add_option("--tile", tile, "side of a tile in pixels")->check(CLI::IsMember({4, 8, 16}))->capture_default_str();
  command.add_option("--ports", ports, "memory ports of the core")->check(CLI::IsMember({1, 2}))->capture_default_str();
  command.add_option("--l2", l2_kbytes, "KB of the shared cache; 0: none")->check(CLI::Range(0, 1 << 20))->capture_default_str();
  command
      .add_option(
          "--mode", mode,
          "how primitives are found: bvh, the hierarchy from each tile's start; bvh_root, from its root; brute, all are tested")
      ->check(CLI::IsMember(std::vector<std::string>(sim::kModeNames.begin(), sim::kModeNames.end())))
      ->capture_default_str();
  command.add_option("--steps", steps, "nodes that a ray may visit, or the job ends with an error; 0: no limit")
      ->check(CLI::Range(0, (1 << steps_t_bits) - 1))
      ->capture_default_str();
  command.add_option("--memory", memory, "timing of the memory: reference, or hp with 8 requests outstanding")
      ->check(CLI::IsMember({"reference", "hp"}))->capture_default_str();
  command.add_option("--stalls", stalls, "pattern of stalls on the five channels of the memory")
      ->check(CLI::IsMember(sim::Stalls::names()))->capture_default_str();
  command.add_flag("--reorder", reorder, "responses of different IDs overtake each other");
  command.add_option("--seed", seed, "of stalls, order and registers without reset")->check(whole_number)->capture_default_str();
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

sim::Mode CoreArguments::render_mode() const {
  return static_cast<sim::Mode>(std::find(sim::kModeNames.begin(), sim::kModeNames.end(), mode) - sim::kModeNames.begin());
}

sim::RenderOptions CoreArguments::replay(const Scene& scene, int x, int y) const {
  sim::RenderOptions options{.hits = true, .work = true, .mode = render_mode(), .steps = steps, .window = sim::PixelWindow{x, y, x + 1, y + 1}};
  if (options.mode == sim::Mode::kBvh) {
    const auto low = [&](int at) { return at / tile * tile; };
    options.window = {low(x), low(y), std::min(low(x) + tile, scene.width), std::min(low(y) + tile, scene.height)};
  }
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
  if (mode != none.mode) text += " --mode " + mode;
  if (steps != none.steps) text += " --steps " + std::to_string(steps);
  if (memory != none.memory) text += " --memory " + memory;
  if (stalls != none.stalls) text += " --stalls " + stalls;
  if (reorder) text += " --reorder";
  if (seed != none.seed) text += " --seed " + std::to_string(seed);
  return text;
}

}  // namespace castray::cli
