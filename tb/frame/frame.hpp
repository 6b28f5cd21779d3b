// SPDX-License-Identifier: Apache-2.0
// What tests of whole frames share: a core that stays alive from frame to frame, and the comparison
// of a frame with the model's.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "comparison.hpp"
#include "frame_run.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {

inline Scene scene_of(const std::string& name) { return load_scene("scenes/" + name + ".json"); }

// Every scene file, in the order of the names.
inline const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> sorted = [] {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator("scenes"))
      if (entry.path().extension() == ".json") names.push_back(entry.path().stem());
    std::ranges::sort(names);
    return names;
  }();
  return sorted;
}

struct Core {
  explicit Core(const sim::RtlOptions& options) : device(options), driver(device) {}
  sim::RtlDevice device;
  sim::Driver driver;
};

inline sim::RtlOptions core_of(int lanes, const std::string& stalls = "none", unsigned seed = 1, const std::string& memory = "reference") {
  sim::RtlOptions options;
  // The variants that are built for tests: one port on one and two lanes, no L2 on one.
  options.variant.lanes = lanes;
  options.variant.ports = lanes <= 2 ? 1 : 2;
  options.variant.l2_kbytes = lanes == 1 ? 0 : 128;
  options.timing = sim::AxiTiming::named(memory);
  options.timing.reorder = stalls != "none";
  options.stalls = stalls;
  options.seed = seed;
  return options;
}

// The counters of work.
inline testing::AssertionResult equal(const sim::Counts& rtl, const sim::Counts& model) {
  const std::vector<std::string> differ = sim::counters_that_differ(rtl, model);
  return differ.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << differ.front();
}

// True if nothing differs and the core kept the rules of its bus.
inline testing::AssertionResult equal(const sim::Rendering& rtl, const sim::Rendering& model) {
  if (rtl.error != ErrNone) return testing::AssertionFailure() << "the core stopped: " << meaning(rtl.error);
  const sim::Comparison comparison = sim::compare(rtl, model);
  if (!comparison.equal()) {
    auto failure = testing::AssertionFailure() << comparison.pixels_differ << " pixels and " << comparison.hits_differ << " hits differ";
    for (const std::size_t i : comparison.first)
      failure << "\n  (" << i % static_cast<std::size_t>(rtl.width) << ", " << i / static_cast<std::size_t>(rtl.width) << ")\n    rtl   "
              << sim::text_of(rtl, i) << "\n    model " << sim::text_of(model, i);
    return failure;
  }
  return equal(rtl.counters, model.counters);
}

inline testing::AssertionResult kept_the_rules(sim::RtlDevice& device) {
  if (device.violations() == 0) return testing::AssertionSuccess();
  auto failure = testing::AssertionFailure() << device.violations() << " rules of the bus were broken:";
  for (const std::string& message : device.memory().messages()) failure << "\n  " << message;
  return failure;
}

// Renders on the core and compares.
inline void expect_frame(Core& core, const SceneImage& image, const sim::RenderOptions& options = {}) {
  core.driver.load(image);
  const sim::Rendering rtl = core.driver.render(options);
  EXPECT_TRUE(equal(rtl, sim::run_model(image, options)));
  EXPECT_TRUE(kept_the_rules(core.device));
}

}  // namespace castray::tb
