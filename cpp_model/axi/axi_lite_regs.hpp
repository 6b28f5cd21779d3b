// SPDX-License-Identifier: Apache-2.0
// From the argument registers to the job, as rtl/axi/axi_lite_regs.sv latches it at the start.
#pragma once
#include <cstdint>

#include "castray_records.hpp"

namespace castray {

// read(offset) gives the 32-bit register at a byte offset of castray_reg_pkg.
template <class Read> job_t job_of_registers(Read&& read) {
  const auto word = [&](std::int64_t offset) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(read(offset))); };
  const std::uint64_t options = word(RegOptions), size = word(RegFrameSize);
  const std::uint64_t min = word(RegWindowMin), max = word(RegWindowMax);
  const auto pointer = [&](std::int64_t offset) { return word(offset) | (word(offset + 4) << 32); };
  const std::uint64_t extent = (std::uint64_t{1} << extent_t_bits) - 1;
  const auto low = [&](std::uint64_t pair) { return pair & extent; };
  const auto high = [&](std::uint64_t pair) { return (pair >> 16) & extent; };
  const std::uint64_t address = (std::uint64_t{1} << AddrW) - 1, most_rays = (std::uint64_t{1} << ray_count_t_bits) - 1;

  job_t job;
  job.image = pointer(RegImage) & address;
  job.frame = pointer(RegFrame) & address;
  job.hits = pointer(RegHits) & address;
  job.rays = pointer(RegRays) & address;
  job.image_bytes = word(RegImageBytes);
  job.frame_bytes = word(RegFrameBytes);
  job.hits_bytes = word(RegHitsBytes);
  job.ray_bytes = word(RegRayBytes);
  job.ray_count = word(RegRayCount) & most_rays;
  job.width = low(size);
  job.height = high(size);
  job.x0 = low(min);
  job.y0 = high(min);
  job.x1 = max == 0 ? low(size) : low(max);
  job.y1 = max == 0 ? high(size) : high(max);
  job.is_list = (options >> OptionList) & 1;
  job.want_hits = ((options >> OptionHits) & 1) | job.is_list;
  job.want_work = (options >> OptionWork) & 1;
  job.z_order = (options >> OptionZOrder) & 1;
  job.brute = (options >> OptionBrute) & 1;
  job.from_root = (options >> OptionRoot) & 1;
  const std::uint64_t steps = word(RegSteps), most_steps = (std::uint64_t{1} << steps_t_bits) - 1;
  job.steps = steps == 0 ? most_steps : steps & most_steps;

  const bool frame_bad = ((size | min | max) & ~(extent | extent << 16)) != 0 || pointer(RegFrame) > address;
  const bool list_bad = word(RegRayCount) > most_rays || pointer(RegRays) > address;
  job.illegal = (job.is_list ? list_bad : frame_bad) || options >> NumOptions != 0 || (job.want_work && !job.want_hits) || steps > most_steps ||
                pointer(RegImage) > address || (job.want_hits && pointer(RegHits) > address);
  return job;
}

}  // namespace castray
