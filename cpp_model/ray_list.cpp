// SPDX-License-Identifier: Apache-2.0
#include "ray_list.hpp"

#include "camera/ray_setup.hpp"
#include "camera/slab_setup.hpp"
#include "in_parallel.hpp"
#include "mem/hit_writer.hpp"
#include "mem/ray_request.hpp"

namespace castray {
namespace {

constexpr std::uint64_t kPart = 256;   // rays

error_t answer(std::uint64_t number, const job_t& job, const Loaded& loaded, const Windows& windows, WorkCounters& counters) {
  const ray_record_t record = load_ray(windows.rays.data(), number);
  if (!ray_flags_ok(record)) return ErrRay;
  const ray_t ray = slab_setup(ray_setup(ray_request(record, number)));
  const TreeHit found = cast(ray, job, loaded, windows, {}, counters, [](const cand_t&, const result_t*) {});
  if (found.error == ErrNone) store_record(&windows.hits[number * HitBytes], hit_record(found.hit, job.want_work ? found.work : work_t{}));
  return found.error;
}

}  // namespace

Errors ray_errors(const job_t& job, const Windows& windows) {
  for (std::uint64_t i = 0; i < job.ray_count; ++i)
    if (!ray_flags_ok(load_ray(windows.rays.data(), i))) return ErrRay;
  return ErrNone;
}

Outcome run_list(const job_t& job, const Loaded& loaded, const Windows& windows, const RunOptions& options) {
  return in_parallel((job.ray_count + kPart - 1) / kPart, options, [&](std::size_t part, WorkCounters& counters) {
    const std::uint64_t end = std::min<std::uint64_t>((part + 1) * kPart, job.ray_count);
    Errors errors;
    for (std::uint64_t i = part * kPart; i < end && (errors.first == ErrNone || options.every_error); ++i)
      errors += answer(i, job, loaded, windows, counters);
    return errors;
  });
}

}  // namespace castray
