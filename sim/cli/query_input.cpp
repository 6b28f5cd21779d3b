// SPDX-License-Identifier: Apache-2.0
#include "query_input.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "command.hpp"
#include "mem/ray_request.hpp"
#include "scene/camera.hpp"
#include "scene/files.hpp"
#include "scene/text.hpp"

namespace castray::cli {

std::string read_standard_input(std::uint64_t most) {
  std::string bytes;
  std::array<char, 1 << 16> part;
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, part.data(), part.size());
    if (count == 0) return bytes;
    if (count > 0 && static_cast<std::uint64_t>(count) > most - bytes.size()) throw InputError("standard input: read: " + too_many_bytes(most));
    if (count > 0) bytes.append(part.data(), static_cast<std::size_t>(count));
    else if (errno != EINTR) throw InputError(std::string("standard input: read: ") + std::strerror(errno));
  }
}

std::vector<std::uint8_t> parse_records(const std::string& name, const std::string& bytes) {
  if (bytes.empty()) throw InputError(name + ": empty; a ray's record has " + std::to_string(RayBytes) + " bytes");
  if (bytes.size() % RayBytes != 0) throw InputError(name + ": " + counted(bytes.size(), "byte") + " are no whole number of records of " + std::to_string(RayBytes));
  std::vector<std::uint8_t> records(bytes.begin(), bytes.end());
  const std::size_t count = records.size() / RayBytes;
  if (count > std::size_t{MaxRays}) throw InputError(name + ": " + std::to_string(count) + " rays, at most " + std::to_string(MaxRays) + " are possible");
  for (std::size_t i = 0; i < count; ++i)
    if (const ray_record_t record = load_ray(records.data(), i); !ray_flags_ok(record))
      throw InputError(name + ": record " + std::to_string(i) + ": flags of " + std::to_string(record.flags) + ", there are " + std::to_string(NumRayFlags) + " bits");
  return records;
}

std::size_t farthest_origin(const Scene& scene, std::span<const ListRay> rays) {
  Vec3 low, high;
  bounds(scene, low, high);
  const Vec3 middle = (low + high) / 2;
  const auto distance = [&](const ListRay& ray) {
    const Vec3 d = ray.origin - middle;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  };
  return static_cast<std::size_t>(std::ranges::max_element(rays, {}, distance) - rays.begin());
}

}  // namespace castray::cli
