// SPDX-License-Identifier: Apache-2.0
// What a job was and came to, as JSON.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "summary.hpp"

namespace castray::cli {

// The counters by name, the bus, and what was stalled.
nlohmann::ordered_json report_of(const Counts& counters);
nlohmann::ordered_json report_of(const sim::RtlFacts& run, const Counts& counters, const sim::RtlOptions& options);

// Throws PictureError.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

}  // namespace castray::cli
