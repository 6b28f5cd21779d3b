// SPDX-License-Identifier: Apache-2.0
// One frame from a scene image to a rendering, on either device: for the programs and the tests.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "driver.hpp"
#include "rtl_device.hpp"

namespace castray::sim {

struct RtlRun {
  Rendering rendering;
  std::string device;  // its description
  double seconds = 0;  // of the host, for the job alone
  AxiCounters bus;
  std::array<StallShare, kChannels> shares{};
  std::uint64_t violations = 0;           // rules of the bus that the core broke
  std::vector<std::string> messages;      // the first of them

  double cycles_per_second() const { return seconds > 0 ? static_cast<double>(rendering.cycles()) / seconds : 0; }
};

// As run_rtl below: a program that takes one can be shown a core that errs.
using RunRtl = std::function<RtlRun(const SceneImage&, const RtlOptions&, const RenderOptions&, const Progress&)>;

// Throw DeviceError when the core hangs or is not of this build.
RtlRun run_rtl(const SceneImage& image, const RtlOptions& device, const RenderOptions& options = {}, const Progress& progress = {});
Rendering run_model(const SceneImage& image, const RenderOptions& options = {}, const Progress& progress = {}, int threads = 0);

}  // namespace castray::sim
