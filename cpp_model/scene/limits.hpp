// SPDX-License-Identifier: Apache-2.0
// What the numbers of a scene may be.
#pragma once
#include "castray_records.hpp"

namespace castray {

struct Limits {
  double least;
  double most;
  constexpr bool hold(double x) const { return x >= least && x <= most; }
};

inline constexpr Limits kFrameSize{1, MaxFrameSize};
inline constexpr Limits kFieldOfView{0.01, 179};                  // degrees
inline constexpr Limits kCheckerScale{0, (1 << CheckerInt) - 1};  // cells for each unit of texture coordinate

inline constexpr double kLargestCoordinate = 0x1p60;
inline constexpr const char* kOutside = "outside the number range, +-2^60";
inline constexpr int kTextureEnd = 1 << (TexInt - 1);  // texture coordinates lie within +-kTextureEnd, not at it

}  // namespace castray
