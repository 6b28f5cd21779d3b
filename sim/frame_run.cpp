// SPDX-License-Identifier: Apache-2.0
#include "frame_run.hpp"

#include <chrono>

#include "model_device.hpp"

namespace castray::sim {

RtlRun run_rtl(const SceneImage& image, const RtlOptions& device_options, const RenderOptions& options, const Progress& progress) {
  RtlDevice device(device_options);
  Driver driver(device);
  driver.load(image);
  RtlRun run;
  run.device = device.description();
  const auto start = std::chrono::steady_clock::now();
  run.rendering = driver.render(options, progress);
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.bus = device.memory().counters();
  run.shares = device.memory().shares();
  run.violations = device.violations();
  run.messages = device.memory().messages();
  return run;
}

Rendering run_model(const SceneImage& image, const RenderOptions& options, const Progress& progress, int threads) {
  ModelDevice device(threads);
  Driver driver(device);
  driver.load(image);
  return driver.render(options, progress);
}

}  // namespace castray::sim
