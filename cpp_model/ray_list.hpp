// SPDX-License-Identifier: Apache-2.0
// The core's second job: the hits of a list of rays.
#pragma once
#include "loaded.hpp"

namespace castray {

Outcome run_list(const job_t& job, const Loaded& loaded, const Windows& windows, const RunOptions& options);

}  // namespace castray
