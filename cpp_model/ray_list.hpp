// SPDX-License-Identifier: Apache-2.0
// The core's second job: the hits of a list of rays.
#pragma once
#include "loaded.hpp"

namespace castray {

// ErrRay if a ray has a flag that is none. By brute force such a ray and an illegal primitive may be met in either order.
Errors ray_errors(const job_t& job, const Windows& windows);

Outcome run_list(const job_t& job, const Loaded& loaded, const Windows& windows, const RunOptions& options);

}  // namespace castray
