// SPDX-License-Identifier: Apache-2.0
// The figures of a job, for people.
#pragma once
#include <cstdint>
#include <cstdio>
#include <string>

#include "comparison.hpp"
#include "frame_run.hpp"
#include "reference_check.hpp"

namespace castray::cli {

// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);

// A job's counters, and how it went on the Verilated core.
using sim::Counts;
void print_work(const Counts& counters, double seconds, std::FILE* out = stdout);
// Those that only a core has; `with` is said of the cycles.
void print_counters(const Counts& counters, std::FILE* out = stdout, const char* with = "");
void print_run(const sim::RtlFacts& run, const Counts& counters, std::FILE* out = stdout, const char* with = "");
void print_violations(const sim::RtlFacts& run, std::FILE* out = stdout);

void print_comparison(const sim::Comparison& comparison, const sim::Rendering& rendering);
void print_reference(const sim::ReferenceCheck& check);

}  // namespace castray::cli
