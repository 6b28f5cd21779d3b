// SPDX-License-Identifier: Apache-2.0
// The figures of a rendering, for people, on stdout.
#pragma once
#include <cstdint>
#include <string>

#include "comparison.hpp"
#include "frame_run.hpp"
#include "reference_check.hpp"

namespace castray::cli {

// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);

void print_run(const sim::RtlRun& run);
void print_violations(const sim::RtlRun& run);
void print_work(const sim::Rendering& rendering, double seconds);
void print_comparison(const sim::Comparison& comparison, const sim::Rendering& rendering);
void print_reference(const sim::ReferenceCheck& check);

}  // namespace castray::cli
