// SPDX-License-Identifier: Apache-2.0
// Two outcomes of the same job: every pixel, every raw hit record, the counters of work.
#pragma once
#include <string>
#include <vector>

#include "driver.hpp"

namespace castray::sim {

struct Comparison {
  std::size_t pixels_differ = 0;
  std::size_t hits_differ = 0;
  std::vector<std::size_t> first;  // the first few pixels that differ in either, by index

  bool equal() const { return pixels_differ == 0 && hits_differ == 0; }
};

// Hit records are compared if both have them. Renderings of different sizes differ everywhere.
Comparison compare(const Rendering& a, const Rendering& b);

// The same of the answers to one list of rays: hits_differ, and `first` by the ray's number.
Comparison compare(const Answers& a, const Answers& b);

// A line for each counter of cpp_model/work_counters.hpp that differs: its name and both values. Of jobs in the same mode, on tiles
// of one size, both with hit records or both without.
std::vector<std::string> counters_that_differ(const Counts& core, const Counts& model);

// Pixel and hit record of one place as text.
std::string text_of(const Rendering& rendering, std::size_t pixel);

}  // namespace castray::sim
