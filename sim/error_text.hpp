// SPDX-License-Identifier: Apache-2.0
// Error codes of the core, for people.
#pragma once
#include "castray_records.hpp"

namespace castray::sim {

inline const char* error_text(error_t error) {
  switch (error) {
    case ErrNone: return "no error";
    case ErrRegister: return "ErrRegister: a register holds an illegal value";
    case ErrImage: return "ErrImage: not a scene image of this version";
    case ErrParameters: return "ErrParameters: an image for other bit widths";
    case ErrSection: return "ErrSection: a section of the image lies outside it";
    case ErrFrameRecord: return "ErrFrameRecord: the frame record is for another frame size, or illegal";
    case ErrFrameWindow: return "ErrFrameWindow: the frame buffer is too small";
    case ErrHitWindow: return "ErrHitWindow: the hit buffer is too small";
    case ErrReadBus: return "ErrReadBus: an error response to a read";
    case ErrWriteBus: return "ErrWriteBus: an error response to a write";
    case ErrPrimitive: return "ErrPrimitive: a primitive's number is out of range";
    case ErrNode: return "ErrNode: a node is illegal, out of range, or not behind its parent";
    case ErrLeaf: return "ErrLeaf: a leaf is out of range";
    case ErrStack: return "ErrStack: the hierarchy is deeper than a ray's stack";
    case ErrSteps: return "ErrSteps: a ray visited more nodes than the job allows";
    case ErrRay: return "ErrRay: a ray of the list is illegal";
  }
  return "an error code that this program does not know";
}

}  // namespace castray::sim
