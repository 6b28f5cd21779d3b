// SPDX-License-Identifier: Apache-2.0
// What castray query is given beside text: bytes of standard input, raw records.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/list_ray.hpp"

namespace castray::cli {

// All of it. Throws InputError when it cannot be read, or has more than so many bytes.
std::string read_standard_input(std::uint64_t most);

// The bytes of ray_record_t. Throws InputError "name: cause" where they are none, not whole, too many, or a
// flag of one is none; whatever else they hold is a ray or a miss.
std::vector<std::uint8_t> parse_records(const std::string& name, const std::string& bytes);

// The ray that starts farthest from the middle of the scene.
std::size_t farthest_origin(const Scene& scene, std::span<const ListRay> rays);

}  // namespace castray::cli
