// SPDX-License-Identifier: Apache-2.0
#include "loaded.hpp"

#include "camera/frame_setup.hpp"
#include "mem/prim_reader.hpp"
#include "shade/paint.hpp"

namespace castray {

Loaded load(const job_t& job, const Windows& windows) {
  Loaded loaded;
  loaded.error = check_image(windows.image.data(), windows.image.size(), job, loaded.header, loaded.record);
  if (loaded.error != ErrNone) return loaded;
  loaded.camera = frame_setup(loaded.record);
  loaded.paint = frame_paint(loaded.record);
  if (job.brute) {
    loaded.slots = read_slots(windows.image.data(), loaded.header);
    for (const prim_slot_t& slot : loaded.slots)
      if (!slot_ok(slot, loaded.header)) loaded.error = ErrPrimitive;
  }
  return loaded;
}

}  // namespace castray
