// SPDX-License-Identifier: Apache-2.0
// Lists of rays for spoilt scene images.
#pragma once
#include "frame/spoilt_image.hpp"
#include "mem/ray_request.hpp"

namespace castray::tb {

// The rays of a list, from the eye of the good image and from anywhere; of every second list some bits are spoilt, too.
inline std::vector<std::uint8_t> rays_for(const Spoilt& spoilt, unsigned seed) {
  constexpr std::size_t kRays = 96;
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes(kRays * RayBytes);
  for (std::size_t i = 0; i < kRays; ++i) {
    ray_record_t ray;
    const auto coord = [&](std::uint64_t eye) { return i % 2 ? eye : random() % (std::uint64_t{1} << CoordW); };
    const auto component = [&] { return static_cast<std::int64_t>(random()) >> (64 - DirFrac); };
    ray.org_x = coord(spoilt.image.frame.eye_x), ray.org_y = coord(spoilt.image.frame.eye_y), ray.org_z = coord(spoilt.image.frame.eye_z);
    ray.dir_x = component(), ray.dir_y = component(), ray.dir_z = component();
    ray.tmax = TMax;
    ray.flags = random() % (1 << NumRayFlags);
    ray.ignore = random() % 4 ? NoHit : random() % 8;
    store_record(&bytes[i * RayBytes], ray);
  }
  if (seed % 2)
    for (int i = 0; i < 4; ++i) bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1 << random() % 8);
  return bytes;
}

}  // namespace castray::tb
