// SPDX-License-Identifier: Apache-2.0
#include "reference/float64.hpp"

#include "reference/brute.hpp"

namespace castray {

ReferenceFrame trace_float64(const Scene& scene, int width, int height, int threads, const RowProgress& progress) {
  return reference::trace<double>(scene, width, height, threads, progress);
}

ReferencePixel trace_float64(const Scene& scene, int width, int height, int x, int y) {
  return reference::Tracer<double>(scene, width, height).pixel(x, y);
}

}  // namespace castray
