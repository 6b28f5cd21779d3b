// SPDX-License-Identifier: Apache-2.0
#include "reference/float32.hpp"

#include "reference/brute.hpp"

namespace castray {

ReferenceFrame trace_float32(const Scene& scene, int width, int height, int threads, const RowProgress& progress) {
  return reference::trace<float>(scene, width, height, threads, progress);
}

}  // namespace castray
