// SPDX-License-Identifier: Apache-2.0
// Reading a scene image: its header, frame record, primitives and attributes, and the checks
// that rtl/control/job_control.sv (check_job) and rtl/mem/job_loader.sv (check_records) make,
// in their order: the first failure is the job's error code.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "fixed.hpp"

namespace castray {

// A record from its little-endian bytes in memory, and back.
template <class Record> Record load_record(const std::uint8_t* bytes) {
  static_assert(Record::kBits % 32 == 0 && std::endian::native == std::endian::little);
  packed_t<Record> words;
  std::memcpy(words.data(), bytes, sizeof words);
  return unpack<Record>(words.data());
}
template <class Record> void store_record(std::uint8_t* bytes, const Record& record) {
  static_assert(Record::kBits % 32 == 0 && std::endian::native == std::endian::little);
  const packed_t<Record> words = pack(record);
  std::memcpy(bytes, words.data(), sizeof words);
}

inline image_header_t load_header(const std::uint8_t* image) { return load_record<image_header_t>(image); }
inline frame_record_t load_frame_record(const std::uint8_t* image) {
  return load_record<frame_record_t>(image + HeaderBytes);
}

// Slots are numbered through the lines: two a line, the first at the lower address.
inline std::uint64_t slot_count(const image_header_t& header) { return header.lines.count * (LineBytes / SlotBytes); }
inline prim_slot_t load_slot(const std::uint8_t* image, const image_header_t& header, std::uint64_t slot) {
  return load_record<prim_slot_t>(image + header.lines.offset + slot * SlotBytes);
}
inline node_t load_node(const std::uint8_t* image, const image_header_t& header, std::uint64_t index) {
  return load_record<node_t>(image + header.nodes.offset + index * NodeBytes);
}
inline attr_t load_attr(const std::uint8_t* image, const image_header_t& header, std::uint64_t number) {
  return load_record<attr_t>(image + header.attributes.offset + number * AttrBytes);
}

// ---- Checks ----

// job_control, before anything is read: ErrRegister or ErrNone.
inline error_t check_job(const job_t& job) {
  const std::uint64_t space = std::uint64_t{1} << AddrW;
  const auto window_ok = [&](std::uint64_t base, std::uint64_t bytes, std::uint64_t align) {
    return base % align == 0 && base + bytes <= space;
  };
  const auto range_ok = [](std::uint64_t first, std::uint64_t end, std::uint64_t size) {
    return size >= 1 && size <= MaxFrameSize && first < end && end <= size;
  };
  const bool frame_ok = range_ok(job.x0, job.x1, job.width) && range_ok(job.y0, job.y1, job.height) &&
                        window_ok(job.frame, job.frame_bytes, BufferAlign);
  const bool list_ok = job.ray_count >= 1 && job.ray_count <= MaxRays && window_ok(job.rays, job.ray_bytes, BufferAlign);
  const bool ok = !job.illegal && (job.is_list ? list_ok : frame_ok) && window_ok(job.image, job.image_bytes, ImageAlign) &&
                  job.image_bytes >= HeaderBytes + FrameBytes &&
                  (!job.want_hits || window_ok(job.hits, job.hits_bytes, BufferAlign));
  return ok ? ErrNone : ErrRegister;
}

// A section is unused, or lies behind the frame record and inside the image, aligned.
inline bool section_ok(const section_t& section, std::uint64_t record_bytes, std::uint64_t image_bytes) {
  return section.count == 0 || (section.offset % ImageAlign == 0 && section.offset != 0 &&
                                section.offset + section.count * record_bytes <= image_bytes);
}

// A reference that an image may hold. Where its index lies is seen when a ray goes there.
inline bool root_ok(ref_word_t root) {
  const std::uint64_t kind = root >> LineW;
  return root == 0 || kind == static_cast<std::uint64_t>(RefNode) || kind == static_cast<std::uint64_t>(RefLeaf);
}

// job_loader, on what it read.
inline error_t check_records(const image_header_t& header, const frame_record_t& frame, const job_t& job) {
  if (header.magic != static_cast<std::uint64_t>(ImageMagic) || header.version != static_cast<std::uint64_t>(ImageVersion))
    return ErrImage;
  if (header.parameters != static_cast<std::uint64_t>(ImageParameters)) return ErrParameters;
  if (header.image_bytes > job.image_bytes) return ErrSection;
  if (!section_ok(header.lines, LineBytes, header.image_bytes)) return ErrSection;
  if (!section_ok(header.attributes, AttrBytes, header.image_bytes)) return ErrSection;
  if (!section_ok(header.nodes, NodeBytes, header.image_bytes)) return ErrSection;
  if (header.primitives > header.attributes.count) return ErrSection;
  if (header.primitives > static_cast<std::uint64_t>(NoPrim)) return ErrPrimitive;
  if (!root_ok(header.root)) return ErrNode;
  if (job.is_list) {
    if (job.ray_count * RayBytes > job.ray_bytes) return ErrRayWindow;
    return job.ray_count * HitBytes > job.hits_bytes ? ErrHitWindow : ErrNone;
  }
  const std::uint64_t row = job.width * PixelBytes;
  if (frame.width != job.width || frame.height != job.height || frame.stride % BufferAlign != 0 || frame.stride < row ||
      frame.pixel_format > static_cast<std::uint64_t>(PixelBgra8) || (frame.eye_x >> CoordW) != 0 ||
      (frame.eye_y >> CoordW) != 0 || (frame.eye_z >> CoordW) != 0 || (frame.pitch >> ScaleFrac) != 0 ||
      (frame.focal >> ScaleFrac) != 0 || (frame.checker_scale >> checker_t_bits) != 0)
    return ErrFrameRecord;
  if (frame.stride * job.height > job.frame_bytes) return ErrFrameWindow;
  if (job.want_hits && job.width * job.height * HitBytes > job.hits_bytes) return ErrHitWindow;
  return ErrNone;
}

// The whole, on `size` bytes of memory from the image's first: what does not lie there is
// answered by the bus with an error. Header and frame record are valid unless the code is
// ErrRegister or ErrReadBus.
inline error_t check_image(const std::uint8_t* bytes, std::size_t size, const job_t& job, image_header_t& header,
                           frame_record_t& frame) {
  if (const error_t error = check_job(job); error != ErrNone) return error;
  if (size < static_cast<std::size_t>(HeaderBytes + FrameBytes)) return ErrReadBus;
  header = load_header(bytes);
  frame = load_frame_record(bytes);
  return check_records(header, frame, job);
}
inline error_t check_image(const std::uint8_t* bytes, std::size_t size, const job_t& job) {
  image_header_t header;
  frame_record_t frame;
  return check_image(bytes, size, job, header, frame);
}

// True if a slot is empty or its number is one of the image's. The RTL meets a wrong one while it
// reads the primitives: ErrPrimitive, in the midst of the job.
inline bool slot_ok(const prim_slot_t& slot, const image_header_t& header) {
  return slot.number == static_cast<std::uint64_t>(NoPrim) || slot.number < header.primitives;
}

}  // namespace castray
