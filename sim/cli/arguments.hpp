// SPDX-License-Identifier: Apache-2.0
// Options that several commands take: which scene at which size, and on which core.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "castray_records.hpp"
#include "command.hpp"
#include "driver.hpp"
#include "rtl_device.hpp"
#include "scene/scene.hpp"

namespace castray::cli {

// A word as a shell reads it: in quotes where it needs them.
std::string shell_word(const std::string& word);

// Two whole numbers in decimal digits and what stands between them, "320x240"; nothing else.
std::optional<std::pair<std::uint64_t, std::uint64_t>> parse_pair(const std::string& text, char between);

// For check(): empty, or what is wrong. CLI11 takes "-1" for the largest number there is.
std::string whole_number(const std::string& text);

// The same of the name of a file that is to be written.
std::string output_name(const std::string& text);

struct SceneArguments {
  std::string file;
  std::optional<std::string> size;  // none: the scene's own

  void add_to(CLI::App& command);
  // Loads the scene, its width and height those asked for.
  Scene load() const;
  // Prints its warnings, and what was chosen where it left something open, to stderr: once nothing
  // more can be refused, so that a refusal is one line.
  void print_notes(const Scene& scene) const;
};

inline const char* name_of(sim::Mode mode) { return sim::kModeNames[static_cast<std::size_t>(mode)]; }

// Who traces. The first three take jobs and write hit records.
struct EngineArgument {
  std::string name = "rtl";

  void add_to(CLI::App& command);
  bool is_device() const { return is_core() || name == "model"; }
  bool is_core() const { return name == "rtl" || name == "uio"; }  // and not a program
};

struct CoreArguments {
  int lanes = DefaultLanes;
  int contexts = DefaultContexts;
  int tile = 1 << DefaultTileLog2;
  int ports = DefaultPorts;
  int l2_kbytes = DefaultL2Kbytes;
  std::string mode = name_of(sim::Mode::kBvh);
  std::uint32_t steps = 0;
  std::string memory = "reference";
  std::string stalls = "none";
  bool reorder = false;
  std::uint64_t seed = 1;

  void add_to(CLI::App& command);
  sim::RtlOptions options() const;
  sim::Mode render_mode() const;
  // Renders one pixel again: with all that shares its start, the pixels of its tile.
  sim::RenderOptions replay(const Scene& scene, int x, int y) const;
  // The options that differ from their defaults, as on a command line.
  std::string text() const;
};

}  // namespace castray::cli
