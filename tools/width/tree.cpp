// SPDX-License-Identifier: Apache-2.0
// One point of the width study, tools/width/study.py, of the widths of the test of boxes: the work of frames in the hierarchy, and
// hits that brute force does not find, as a line of JSON. Linked to the library, as point.cpp is.
#include <cstdio>

#include "core.cpp"
#include "loaded.cpp"
#include "ray_list.cpp"
#include "scene/compile.cpp"
#include "scene/frame.cpp"
#include "scene/grid.cpp"
#include "scene/load.hpp"

namespace castray::width {
namespace {

struct Run {
  std::vector<std::uint8_t> hits;
  WorkCounters work;
};

Run run(const SceneImage& image, bool brute) {
  const frame_record_t& record = image.frame;
  Run out;
  out.hits.resize(record.width * record.height * HitBytes);
  std::vector<std::uint8_t> frame(record.stride * record.height);
  job_t job;
  job.image_bytes = image.bytes.size(), job.frame_bytes = frame.size(), job.hits_bytes = out.hits.size();
  job.width = job.x1 = record.width, job.height = job.y1 = record.height;
  job.want_hits = 1, job.brute = brute, job.steps = 1 << 20;
  const Outcome outcome = run_job(job, {.image = image.bytes, .frame = frame, .hits = out.hits}, {.threads = 1});
  if (outcome.error != ErrNone) throw std::runtime_error("the job ended with error " + std::to_string(outcome.error));
  out.work = outcome.counters;
  return out;
}

std::size_t records_that_differ(const Run& a, const Run& b) {
  std::size_t differ = 0;
  for (std::size_t at = 0; at < a.hits.size(); at += HitBytes) differ += std::memcmp(&a.hits[at], &b.hits[at], HitBytes) != 0;
  return differ;
}

void print() {
  const char* names[] = {"teapot", "teapot_tight", "teapot_interior", "spheres"};
  std::printf("{\"views\": {");
  for (const char* name : names) {
    const Scene scene = load_scene(std::string("scenes/") + name + ".json");
    const SceneImage small = compile(scene, 80, 60), whole = compile(scene, 320, 240);
    const WorkCounters work = run(whole, false).work;
    std::printf("%s\"%s\": {\"nodes\": %lu, \"tests\": %lu, \"differ\": %zu}", name == names[0] ? "" : ", ", name, work.nodes, work.tests,
                records_that_differ(run(small, false), run(small, true)));
  }
  std::printf("}}\n");
}

}  // namespace
}  // namespace castray::width

int main() { castray::width::print(); }
