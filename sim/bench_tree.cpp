// SPDX-License-Identifier: Apache-2.0
#include "bench_tree.hpp"

#include "bench_text.hpp"

namespace castray::bench {
namespace {

std::string tree_row(const Json& r) {
  const std::string contexts = r["contexts"] == DefaultContexts ? "" : format(" of %d context", r["contexts"].get<int>());
  return format("| %s | %s | %s | %s | %d%s | %d | %d | %s |", text(r, "scene").c_str(), text(r, "view").c_str(),
                size_of(r).c_str(), text(r, "mode").c_str(), r["lanes"].get<int>(), contexts.c_str(), r["ports"].get<int>(),
                r["l2_kbytes"].get<int>(), text(r, "memory").c_str());
}

}  // namespace

// There is one for the default core and the memory `reference`.
std::uint64_t bar_of(const Json& r) {
  if (r["part"] != "tree" || r["lanes"] != DefaultLanes || r["ports"] != DefaultPorts || r["l2_kbytes"] != DefaultL2Kbytes || r["memory"] != "reference" ||
      r["contexts"] != DefaultContexts || r["width"] != 320)
    return 0;
  const std::string name = text(r, "scene") + " " + text(r, "view") + " " + text(r, "mode");
  return name == "teapot base bvh"       ? 100'000
         : name == "teapot tight bvh"    ? 180'000
         : name == "teapot base bvh_root" ? 180'000
         : name == "teapot100k base bvh" ? 240'000
         : name == "teapot1m base bvh"   ? 500'000
                                         : 0;
}

std::string tree(const std::vector<Json>& records) {
  const std::vector<Json> rows = only(records, "tree");
  std::string out =
      "\n## The hierarchy\n"
      "Frames in the hierarchy, from the start of tiles (`bvh`) and from the root (`bvh_root`); caches cold, no hit buffer (`hits that differ` are of a\n"
      "second frame, with it). The report's frame took 166.5 M cycles. Embree's columns: rays a second in this run, one thread, one ray at a time\n"
      "and the best of its packets; beside it castray's rays at the report's clock, 100 MHz.\n\n"
      "| scene | view | frame | mode | lanes | ports | L2, KB | memory | cycles | at most | times fewer than the report's | rays a cycle | "
      "rays at 100 MHz | Embree, single | packets | pixels / hits that differ |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : rows) {
    const std::uint64_t bar = bar_of(r);
    const bool reports = r["scene"] == "teapot" && r["view"] == "base" && r["width"] == 320;
    const Json* embree =
        find(records, [&](const Json& e) { return e["part"] == "embree" && e["scene"] == r["scene"] && e["view"] == r["view"]; });
    std::string single = "-", packets = "-";
    if (embree && r["width"] == 320) {
      double best = 0;
      for (const char* packet : {"4", "8", "16"}) best = std::max(best, (*embree)["rays_per_second"][packet].get<double>());
      single = format("%.2f M/s", (*embree)["rays_per_second"]["1"].get<double>() / 1e6);
      packets = format("%.2f M/s", best / 1e6);
    }
    out += tree_row(r) + format(" %lu | %s | %s | %.3f | %.1f M/s | %s | %s | %s |\n", r["cycles"].get<unsigned long>(),
                                bar ? format("%lu", static_cast<unsigned long>(bar)).c_str() : "-",
                                reports ? format("%.0f", kReportCycles / r["cycles"].get<double>()).c_str() : "-",
                                r["rays_per_cycle"].get<double>(), 100 * r["rays_per_cycle"].get<double>(), single.c_str(),
                                packets.c_str(), differ(r).c_str());
  }
  out +=
      "\nThe work and the load, of the same frames. A ray is a pixel, those of empty tiles too. Shares of the cycles in which a unit is used, at its\n"
      "rate: a node or a test a cycle in each lane, a cycle a candidate in the one hit unit, four a node of a tile's start, two a shaded\n"
      "hit. Hit rates of each cache; a lookup of a line that is on its way is a miss.\n\n"
      "| scene | view | frame | mode | lanes | ports | L2, KB | memory | nodes a ray | tests a ray | bytes read a ray | written | node pipe | primitive pipe | "
      "divider | tile start | shading | read ports | write port | node cache | leaf cache | tile cache | L2 | attributes |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : rows) {
    out +=
        tree_row(r) + format(" %.2f | %.2f | %.1f | %.1f |", r["nodes_per_ray"].get<double>(), r["tests_per_ray"].get<double>(),
                             r["read_bytes_per_ray"].get<double>(), r["write_bytes_per_ray"].get<double>());
    for (const char* unit : {"node_pipe", "primitive_pipe", "divider", "tile_start", "shading", "read_ports", "write_port"})
      out += " " + percent(r["utilisation"][unit]) + " |";
    for (const char* cache : {"node", "leaf", "tile", "l2", "attr"}) out += " " + percent(r["hit_rate"][cache]) + " |";
    out += "\n";
  }
  for (const Json& r : only(records, "tree_speed"))
    out += format(
        "\nThe teapot's base frame through the Verilated three-lane core, alone on the machine: %.2f s, %.2f M cycles/s.\n",
        r["seconds"].get<double>(), r["cycles_per_second"].get<double>() / 1e6);
  return out;
}

std::string tree_tiles(const std::vector<Json>& records) {
  std::string out =
      "\n## Tiles in the hierarchy\nThe teapot's base view at 320x240, three lanes, two ports, an L2 of 128 KB, `reference`, no hit buffer.\n\n"
      "| tile | walk | cycles | nodes of tile starts | empty tiles | nodes a ray | tests a ray | tile start | node pipe | read beats | write beats | differ |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "tree_tiles"))
    out += format("| %dx%d | %s | %lu | %lu | %lu | %.2f | %.2f | %s | %s | %lu | %lu | %s |\n", r["tile"].get<int>(), r["tile"].get<int>(),
                  text(r, "walk").c_str(), r["cycles"].get<unsigned long>(), r["tile_nodes"].get<unsigned long>(),
                  r["empty_tiles"].get<unsigned long>(), r["nodes_per_ray"].get<double>(), r["tests_per_ray"].get<double>(),
                  percent(r["utilisation"]["tile_start"]).c_str(), percent(r["utilisation"]["node_pipe"]).c_str(),
                  r["read_beats"].get<unsigned long>(), r["write_beats"].get<unsigned long>(), differ(r).c_str());
  return out;
}

std::string tree_stalls(const std::vector<Json>& records) {
  std::string out =
      "\n## Stalls in the hierarchy\nTwo ports, an L2 of 128 KB, `reference`, responses of different IDs reordered, the hit buffer written; columns as under *Stalls*.\n\n"
      "| scene | frame | lanes | pattern | cycles | ar | r | aw | w | b | differ |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "tree_stalls"))
    out += format("| %s | %s | %d | %s | %lu |%s %s |\n", text(r, "scene").c_str(), size_of(r).c_str(), r["lanes"].get<int>(),
                  text(r, "stalls").c_str(), r["cycles"].get<unsigned long>(), blocked(r).c_str(), differ(r).c_str());
  return out;
}

std::string lists(const std::vector<Json>& records) {
  std::string out =
      "\n## A list of rays\nThe 76,800 camera rays of the teapot's base view as a list, 64 bytes each, their hit records written, 32 bytes each. Three lanes, an L2\n"
      "of 128 KB. A ray takes a port four cycles to read.\n\n"
      "| ports | memory | cycles | cycles a ray | nodes a ray | tests a ray | read bytes a ray | records that differ from the frame's |\n|---|---|---|---|---|---|---|---|\n";
  for (const Json& r : only(records, "list"))
    out += format("| %d | %s | %lu | %.2f | %.2f | %.2f | %.1f | %lu |\n", r["ports"].get<int>(), text(r, "memory").c_str(),
                  r["cycles"].get<unsigned long>(), 1 / r["rays_per_cycle"].get<double>(), r["nodes_per_ray"].get<double>(),
                  r["tests_per_ray"].get<double>(), r["read_bytes_per_ray"].get<double>(), r["hits_differ"].get<unsigned long>());
  return out;
}

}  // namespace castray::bench
