// SPDX-License-Identifier: Apache-2.0
// One frame from a scene image to a rendering, or one list of rays to its hits, on either device: for
// the programs and the tests.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "driver.hpp"
#include "rtl_device.hpp"

namespace castray::sim {

// How it went on the Verilated core.
struct RtlFacts {
  std::string device;  // its description
  double seconds = 0;  // of the host, for the job alone
  AxiCounters bus;
  std::array<StallShare, kChannels> shares{};
  std::uint64_t violations = 0;           // rules of the bus that the core broke
  std::vector<std::string> messages;      // the first of them

  double per_second(std::uint64_t cycles) const { return seconds > 0 ? static_cast<double>(cycles) / seconds : 0; }
};

struct RtlRun : RtlFacts {
  Rendering rendering;
  double cycles_per_second() const { return per_second(rendering.cycles()); }
};

struct RtlQuery : RtlFacts {
  Answers answers;
  double cycles_per_second() const { return per_second(answers.cycles()); }
};

// As run_rtl and query_rtl below: a program that takes them can be shown a core that errs.
using RunRtl = std::function<RtlRun(const SceneImage&, const RtlOptions&, const RenderOptions&, const Progress&)>;
using QueryRtl = std::function<RtlQuery(const SceneImage&, std::span<const std::uint8_t>, const RtlOptions&, const QueryOptions&, const Progress&)>;

// Throw DeviceError when the core hangs or is not of this build.
RtlRun run_rtl(const SceneImage& image, const RtlOptions& device, const RenderOptions& options = {}, const Progress& progress = {});
// Of the model, the counters of work are those of a core with tiles of 2^tile_log2 pixels a side.
Rendering run_model(const SceneImage& image, const RenderOptions& options = {}, const Progress& progress = {}, int threads = 0,
                    int tile_log2 = DefaultTileLog2);

// The same of a list of raw ray_record_t.
RtlQuery query_rtl(const SceneImage& image, std::span<const std::uint8_t> rays, const RtlOptions& device, const QueryOptions& options = {},
                   const Progress& progress = {});
Answers query_model(const SceneImage& image, std::span<const std::uint8_t> rays, const QueryOptions& options = {},
                    const Progress& progress = {}, int threads = 0);

}  // namespace castray::sim
