// SPDX-License-Identifier: Apache-2.0
// The same tracer in float: the baseline of what a processor does by brute force.
#pragma once
#include "reference/float64.hpp"

namespace castray {

ReferenceFrame trace_float32(const Scene& scene, int width, int height, int threads = 0, const RowProgress& progress = {});

}  // namespace castray
