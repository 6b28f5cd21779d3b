// SPDX-License-Identifier: Apache-2.0
// What both kinds of job share: what is read of the image before any ray, and a lane's work for one.
#pragma once
#include <vector>

#include "core.hpp"
#include "traverse/lane.hpp"
#include "traverse/tile_start.hpp"

namespace castray {

// What is read from the image, and made of it, once a job.
struct Loaded {
  error_t error = ErrNone;
  image_header_t header;
  frame_record_t record;
  camera_t camera;
  paint_t paint;
  std::vector<prim_slot_t> slots;   // for brute force
};

Loaded load(const job_t& job, const Windows& windows);

// Where the rays of a tile start, and the nodes of its frontier.
struct Started {
  std::uint64_t start = TileRoot;
  std::span<const node_t> nodes;
};

// A lane's work for one ray, and what it adds to the counters.
template <class Accepted, class Watch = NoWatch>
TreeHit cast(const ray_t& ray, const job_t& job, const Loaded& loaded, const Windows& windows, const Started& started,
             WorkCounters& counters, Accepted&& accepted, Watch&& watch = {}) {
  const auto on_accepted = [&](const cand_t& cand, const result_t* result) {
    ++counters.candidates;
    accepted(cand, result);
  };
  TreeHit found;
  if (job.brute) {
    std::uint64_t tests = 0;
    found.hit = lane(ray, loaded.slots, tests, on_accepted, watch);
    found.work.tests = tests;
  } else {
    const Tree tree{.image = windows.image.data(), .header = &loaded.header, .limit = job.steps, .tile = started.nodes};
    found = lane(ray, tree, start_of(started.start, tree.root().first), on_accepted, watch);
  }
  counters.tests += found.work.tests;
  counters.nodes += found.work.nodes;
  ++counters.rays;
  counters.hits += found.hit.found;
  return found;
}

}  // namespace castray
