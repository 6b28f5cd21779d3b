// SPDX-License-Identifier: Apache-2.0
// The Verilated core without the name of its class. Every build variant (lanes, contexts, tile size, ports, L2)
// is a shared object of its own under build/cores, made from core_instance.cpp (tools/core.mk), so
// that a program needs only those that it uses.
#pragma once
#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "castray_records.hpp"
#include "memory_ports.hpp"

namespace castray::sim {

struct CoreVariant {
  int lanes = DefaultLanes;
  int contexts = DefaultContexts;
  int tile_log2 = DefaultTileLog2;
  int ports = DefaultPorts;
  int l2_kbytes = DefaultL2Kbytes;
  auto operator<=>(const CoreVariant&) const = default;

  std::string file(bool waves = false) const;  // l3c32t3p2m128.so; l3c32t3p2m128w.so, built with waveforms
};

class CoreModel {
 public:
  virtual ~CoreModel() = default;

  // At most so many clock cycles; true as soon as the interrupt is high.
  virtual bool run(MemoryPorts& memory, std::uint64_t cycles) = 0;

  // One access each on the AXI4-Lite port; throws std::runtime_error if the core does not answer.
  virtual void write_reg(MemoryPorts& memory, unsigned offset, std::uint32_t value) = 0;
  virtual std::uint32_t read_reg(MemoryPorts& memory, unsigned offset) = 0;

  virtual void reset(MemoryPorts& memory, unsigned cycles) = 0;
  virtual bool has_waves() const = 0;
  // With has_waves: waveforms (FST) of the cycles first <= cycle < last, counted since construction.
  virtual void trace(const std::string& file, std::uint64_t first, std::uint64_t last) = 0;
  virtual std::uint64_t cycle() const = 0;
};

// The one symbol of a variant's shared object.
using CoreFactory = CoreModel* (*)(std::uint64_t seed);
inline constexpr const char* kCoreFactory = "castray_make_core";

// From a folder of variants; an empty name: the folder `cores` beside the program. Throws std::invalid_argument
// with the command that builds it if this variant, or one with waveforms, was not built.
std::unique_ptr<CoreModel> make_core(const CoreVariant& variant, std::uint64_t seed, bool waves = false, const std::string& cores = {});
std::string text_of(const CoreVariant& variant);

}  // namespace castray::sim
