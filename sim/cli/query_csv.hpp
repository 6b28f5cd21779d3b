// SPDX-License-Identifier: Apache-2.0
// Rays and answers of castray query as text: comma-separated values, the columns named by the first
// line. docs/query.md is the reader's version.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "query_answer.hpp"
#include "scene/list_ray.hpp"

namespace castray::cli {

struct RayText {
  std::vector<ListRay> rays;
  std::vector<std::size_t> lines;  // where each stands, from 1
};

// Throws InputError "name:line: cause" on the first line that is not a ray of a scene of so many primitives.
RayText parse_rays(const std::string& name, std::string_view text, std::size_t primitives);

// One line for each, below one with the columns' names. Numbers read back as the same double.
std::string text_of(const std::vector<Answer>& answers);

}  // namespace castray::cli
