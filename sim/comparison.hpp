// SPDX-License-Identifier: Apache-2.0
// Two renderings of the same job, every pixel and every raw hit record.
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

// Pixel and hit record of one place as text.
std::string text_of(const Rendering& rendering, std::size_t pixel);

}  // namespace castray::sim
