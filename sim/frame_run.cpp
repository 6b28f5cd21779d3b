// SPDX-License-Identifier: Apache-2.0
#include "frame_run.hpp"

#include <chrono>

#include "model_device.hpp"

namespace castray::sim {
namespace {

// job(driver) on the Verilated core, timed.
template <class Job> void run_timed(const SceneImage& image, const RtlOptions& options, RtlFacts& facts, Job&& job) {
  RtlDevice device(options);
  Driver driver(device);
  driver.load(image);
  facts.device = device.description();
  const auto start = std::chrono::steady_clock::now();
  job(driver);
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  facts.bus = device.memory().counters();
  facts.shares = device.memory().shares();
  facts.violations = device.violations();
  facts.messages = device.memory().messages();
}

}  // namespace

RtlRun run_rtl(const SceneImage& image, const RtlOptions& device, const RenderOptions& options, const Progress& progress) {
  RtlRun run;
  run_timed(image, device, run, [&](Driver& driver) { run.rendering = driver.render(options, progress); });
  return run;
}

Rendering run_model(const SceneImage& image, const RenderOptions& options, const Progress& progress, int threads, int tile_log2) {
  ModelDevice device(threads, tile_log2);
  Driver driver(device);
  driver.load(image);
  return driver.render(options, progress);
}

RtlQuery query_rtl(const SceneImage& image, std::span<const std::uint8_t> rays, const RtlOptions& device, const QueryOptions& options,
                   const Progress& progress) {
  RtlQuery run;
  run_timed(image, device, run, [&](Driver& driver) { run.answers = driver.query(rays, options, progress); });
  return run;
}

Answers query_model(const SceneImage& image, std::span<const std::uint8_t> rays, const QueryOptions& options, const Progress& progress,
                    int threads) {
  ModelDevice device(threads);
  Driver driver(device);
  driver.load(image);
  return driver.query(rays, options, progress);
}

}  // namespace castray::sim
