// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include "counter_names.hpp"
#include "outputs.hpp"

namespace castray::cli {

using Json = nlohmann::ordered_json;

Json report_of(const Counts& counters) {
  Json json;
  for (const auto& [index, name] : sim::kCounterNames) json[name] = counters[static_cast<std::size_t>(index)];
  return json;
}

Json report_of(const sim::RtlFacts& run, const Counts& counters, const sim::RtlOptions& options) {
  Json json;
  json["lanes"] = options.variant.lanes;
  json["contexts"] = options.variant.contexts;
  json["tile"] = 1 << options.variant.tile_log2;
  json["ports"] = options.variant.ports;
  json["l2_kbytes"] = options.variant.l2_kbytes;
  json["memory"] = options.timing.name;
  json["stalls"] = options.stalls == "none" ? Json() : Json(options.stalls);
  json["seed"] = options.seed;
  json.update(report_of(counters));
  json["seconds"] = run.seconds;
  json["cycles_per_second"] = run.per_second(counters[CntCycles]);
  json["bus"] = {{"reads", run.bus.reads},           {"read_beats", run.bus.read_beats},
                 {"writes", run.bus.writes},         {"write_beats", run.bus.write_beats},
                 {"bytes_written", run.bus.bytes_written}, {"most_reads", run.bus.most_reads},
                 {"most_writes", run.bus.most_writes}, {"rules_broken", run.violations}};
  if (options.stalls != "none") {
    Json shares;
    for (unsigned i = 0; i < sim::kChannels; ++i)
      shares[sim::kChannelNames[i]] = {{"wanted", run.shares[i].wanted}, {"blocked", run.shares[i].blocked}, {"share", run.shares[i].share()}};
    json["stall_shares"] = shares;
  }
  return json;
}

void write_json(const std::filesystem::path& file, const Json& json) {
  write_output(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace castray::cli
