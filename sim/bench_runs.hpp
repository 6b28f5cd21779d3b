// SPDX-License-Identifier: Apache-2.0
// What `make bench` measures: each run gives one record of build/bench.json, an object; the tables
// of docs/bench.md are made of them.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "driver.hpp"

namespace castray::bench {

using Json = nlohmann::ordered_json;

struct Frame {
  std::string file;            // scenes/<file>.json, or the name of a made scene: see bench_scenes.hpp
  std::string scene = "teapot";
  std::string view = "base";
  int width = 80;
  int height = 60;
};

struct Core {
  int lanes = DefaultLanes;
  int contexts = DefaultContexts;
  int tile_log2 = DefaultTileLog2;
  bool z_order = false;
  bool hits = true;            // the hit buffer is written
  std::string stalls = "none";
  int ports = DefaultPorts;
  int l2_kbytes = DefaultL2Kbytes;
  sim::Mode mode = sim::Mode::kBrute;
  std::string memory = "reference";
};

// A frame on the Verilated core, compared with the model in every pixel and every hit record. Without the hit
// buffer the cycles are those of a frame without, and the records are compared in a second one.
Json rtl_run(const Frame& frame, const Core& core);
// A frame's camera rays as a list, compared with the frame's hits in the model.
Json list_run(const Frame& frame, const Core& core);
// The image of a scene: how long its making takes, how large it is.
Json compile_run(const Frame& frame);
// A frame of the model against the float64 reference.
Json reference_run(const Frame& frame);
// A frame of Embree, one ray at a time and in packets, and where it sees another primitive than the model.
Json embree_run(const Frame& frame);
// Times of the float64, the float32 and the fixed-point tracer, one after the other; field_of_view 0
// keeps the scene's own.
Json host_run(const Frame& frame, double field_of_view);

}  // namespace castray::bench
