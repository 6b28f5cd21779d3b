// SPDX-License-Identifier: Apache-2.0
// A small valid image with its job, for tests to spoil: no scene in it, only header and record.
#pragma once
#include <functional>
#include <vector>

#include "mem/image.hpp"

namespace castray::tb {

// Its sections: lines at 256, attributes at 3584 to the end.
constexpr std::uint64_t kImageBytes = 3584 + 100 * AttrBytes;
constexpr std::uint64_t kSpace = std::uint64_t{1} << AddrW;

struct TestImage {
  image_header_t header;
  frame_record_t frame;
  job_t job;

  TestImage() {
    header.magic = ImageMagic;
    header.version = ImageVersion;
    header.parameters = ImageParameters;
    header.primitives = 100;
    header.lines = {.offset = 256, .count = 50};
    header.attributes = {.offset = 3584, .count = 100};
    header.nodes = {.offset = 0, .count = 0};
    header.image_bytes = kImageBytes;
    frame.width = 33;
    frame.height = 17;
    frame.stride = 192;
    frame.pixel_format = PixelRgba8;
    frame.eye_x = 0x3ff'ffff;
    frame.eye_y = 0x2ab'cdef;
    frame.pitch = 0xfff'ffff'ffff;
    frame.focal = 0x123'4567'89ab;
    frame.checker_scale = 0x3'ffff;
    job.image = 0x12'3456'7800;
    job.frame = 0x80'0000'0040;
    job.hits = 0xff'0000'0000;
    job.image_bytes = header.image_bytes;
    job.frame_bytes = 192 * 17;
    job.hits_bytes = 33 * 17 * 32;
    job.width = job.x1 = 33;
    job.height = job.y1 = 17;
    job.want_hits = 1;
  }

  std::vector<std::uint8_t> bytes() const {
    std::vector<std::uint8_t> result(HeaderBytes + FrameBytes);
    store_record(result.data(), header);
    store_record(result.data() + HeaderBytes, frame);
    return result;
  }
};

// The same image with a list of rays, whose windows end with it, and nothing of a frame.
inline void make_list(TestImage& t, std::uint64_t rays = 100) {
  t.frame = {};
  t.job.frame = 7, t.job.frame_bytes = 0;
  t.job.width = t.job.height = t.job.x1 = t.job.y1 = 0;
  t.job.is_list = 1;
  t.job.rays = 0x70'0000'0040, t.job.ray_count = rays, t.job.ray_bytes = rays * 64;
  t.job.hits_bytes = rays * 32;
}

// A way to spoil it, and the code that this gives.
struct Defect {
  const char* name;
  error_t error;
  std::function<void(TestImage&)> spoil;
};

// What the job loader finds, in the order of its steps; each is the nearest illegal value. The
// entries with ErrNone are the last legal ones.
inline const Defect kRecordDefects[] = {
    {"none", ErrNone, [](TestImage& t) {}},
    {"magic", ErrImage, [](TestImage& t) { t.header.magic ^= 0x80000000; }},
    {"version", ErrImage, [](TestImage& t) { t.header.version += 1; }},
    {"parameters", ErrParameters, [](TestImage& t) { t.header.parameters ^= 1; }},
    {"image one byte short", ErrSection, [](TestImage& t) { t.job.image_bytes -= 1; }},
    {"lines unaligned", ErrSection, [](TestImage& t) { t.header.lines.offset += 128; }},
    {"lines in the header", ErrSection, [](TestImage& t) { t.header.lines.offset = 0; }},
    {"lines to the last byte", ErrNone, [](TestImage& t) { t.header.lines.count = (kImageBytes - 256) / 64; }},
    {"lines behind the end", ErrSection, [](TestImage& t) { t.header.lines.count = (kImageBytes - 256) / 64 + 1; }},
    {"lines far behind the end", ErrSection, [](TestImage& t) { t.header.lines.count = 0x0400'0001; }},
    {"lines at the very end", ErrSection, [](TestImage& t) { t.header.lines.offset = 0xffff'ff00; }},
    {"no lines anywhere", ErrNone, [](TestImage& t) { t.header.lines = {.offset = 0xffff'ffff, .count = 0}; }},
    {"attributes unaligned", ErrSection, [](TestImage& t) { t.header.attributes.offset -= 64; }},
    {"attributes one too many", ErrSection, [](TestImage& t) { t.header.attributes.count += 1; }},
    {"nodes to the last byte", ErrNone, [](TestImage& t) { t.header.nodes = {.offset = kImageBytes - 256, .count = 4}; }},
    {"nodes behind the end", ErrSection, [](TestImage& t) { t.header.nodes = {.offset = kImageBytes - 256, .count = 5}; }},
    {"a primitive without attributes", ErrSection, [](TestImage& t) { t.header.primitives = 101; }},
    {"fewer primitives than attributes", ErrNone, [](TestImage& t) { t.header.primitives = 0; }},
    {"all numbers in use", ErrNone, [](TestImage& t) {
       t.header.primitives = t.header.attributes.count = NoPrim;
       t.header.image_bytes = t.job.image_bytes = 3584 + NoPrim * 64;
     }},
    {"more primitives than numbers", ErrPrimitive, [](TestImage& t) {
       t.header.primitives = t.header.attributes.count = NoPrim + 1;
       t.header.image_bytes = t.job.image_bytes = 3584 + (NoPrim + 1) * 64;
     }},
    {"a root that is a node", ErrNone, [](TestImage& t) { t.header.root = static_cast<ref_word_t>(RefNode) << LineW | 5; }},
    {"a root that is a leaf", ErrNone, [](TestImage& t) { t.header.root = static_cast<ref_word_t>(RefLeaf) << LineW | 0x3f'ffff; }},
    {"a root of the chip", ErrNode, [](TestImage& t) { t.header.root = static_cast<ref_word_t>(RefTile) << LineW; }},
    {"a root that is nothing, with an index", ErrNode, [](TestImage& t) { t.header.root = 0x20'0000; }},
    {"a root with a bit above", ErrNode, [](TestImage& t) { t.header.root = static_cast<ref_word_t>(RefNode) << LineW | 1 << 24; }},
    {"a root with the highest bit", ErrNode, [](TestImage& t) { t.header.root = 0x8000'0000; }},
    {"another width", ErrFrameRecord, [](TestImage& t) { t.frame.width = 32; }},
    {"a width with a higher bit", ErrFrameRecord, [](TestImage& t) { t.frame.width |= 0x8000; }},
    {"another height", ErrFrameRecord, [](TestImage& t) { t.frame.height = 18; }},
    {"stride unaligned", ErrFrameRecord, [](TestImage& t) { t.frame.stride = 160; }},
    {"stride below a row", ErrFrameRecord, [](TestImage& t) { t.frame.stride = 128; }},
    {"stride zero", ErrFrameRecord, [](TestImage& t) { t.frame.stride = 0; }},
    {"a full row", ErrNone, [](TestImage& t) { t.frame.width = t.job.width = 48, t.job.hits_bytes = 48 * 17 * 32; }},
    {"one more than a full row", ErrFrameRecord, [](TestImage& t) { t.frame.width = t.job.width = 49, t.job.hits_bytes = 49 * 17 * 32; }},
    {"pixel format bgra", ErrNone, [](TestImage& t) { t.frame.pixel_format = 1; }},
    {"pixel format", ErrFrameRecord, [](TestImage& t) { t.frame.pixel_format = 2; }},
    {"eye x", ErrFrameRecord, [](TestImage& t) { t.frame.eye_x = 0x400'0000; }},
    {"eye y", ErrFrameRecord, [](TestImage& t) { t.frame.eye_y = 0x8000'0000; }},
    {"eye z", ErrFrameRecord, [](TestImage& t) { t.frame.eye_z = 0x400'0000; }},
    {"pitch", ErrFrameRecord, [](TestImage& t) { t.frame.pitch = 1ull << 44; }},
    {"focal", ErrFrameRecord, [](TestImage& t) { t.frame.focal = 1ull << 63; }},
    {"checker", ErrFrameRecord, [](TestImage& t) { t.frame.checker_scale = 1 << 18; }},
    {"frame one byte short", ErrFrameWindow, [](TestImage& t) { t.job.frame_bytes -= 1; }},
    {"frame past 32 bits", ErrFrameWindow, [](TestImage& t) { t.frame.stride = 0x0f0f'0f40, t.job.frame_bytes = 0xffff'ffff; }},
    {"hits one byte short", ErrHitWindow, [](TestImage& t) { t.job.hits_bytes -= 1; }},
    {"no hits wanted", ErrNone, [](TestImage& t) { t.job.hits_bytes = 0, t.job.want_hits = 0; }},
    {"the largest frame", ErrNone, [](TestImage& t) {
       t.frame.width = t.frame.height = t.job.width = t.job.height = 4096;
       t.frame.stride = 16384;
       t.job.frame_bytes = 1u << 26;
       t.job.hits_bytes = 1u << 29;
     }},
    {"the largest frame, hits one byte short", ErrHitWindow, [](TestImage& t) {
       t.frame.width = t.frame.height = t.job.width = t.job.height = 4096;
       t.frame.stride = 16384;
       t.job.frame_bytes = 1u << 26;
       t.job.hits_bytes = (1u << 29) - 1;
     }},
    {"a list", ErrNone, [](TestImage& t) { make_list(t); }},
    {"a list, its rays one byte short", ErrRayWindow, [](TestImage& t) { make_list(t), t.job.ray_bytes -= 1; }},
    {"a list, its hits one byte short", ErrHitWindow, [](TestImage& t) { make_list(t), t.job.hits_bytes -= 1; }},
    {"a list, both one byte short", ErrRayWindow, [](TestImage& t) { make_list(t), t.job.ray_bytes -= 1, t.job.hits_bytes -= 1; }},
    {"the longest list", ErrNone, [](TestImage& t) { make_list(t, MaxRays); }},
    {"the longest list, its rays one byte short", ErrRayWindow, [](TestImage& t) { make_list(t, MaxRays), t.job.ray_bytes -= 1; }},
    {"the longest list, its hits one byte short", ErrHitWindow, [](TestImage& t) { make_list(t, MaxRays), t.job.hits_bytes -= 1; }},
    {"a list in a bad image", ErrSection, [](TestImage& t) { make_list(t), t.header.lines.offset += 128; }},
};

// What job_control finds: ErrRegister; the entries with ErrNone are the last legal ones.
inline const Defect kJobDefects[] = {
    {"a field's bits", ErrRegister, [](TestImage& t) { t.job.illegal = 1; }},
    {"no width", ErrRegister, [](TestImage& t) { t.job.width = 0, t.job.x1 = 0; }},
    {"no height", ErrRegister, [](TestImage& t) { t.job.height = 0, t.job.y1 = 0; }},
    {"width 4097", ErrRegister, [](TestImage& t) { t.job.width = 4097; }},
    {"height 4097", ErrRegister, [](TestImage& t) { t.job.height = 4097; }},
    {"width 8191", ErrRegister, [](TestImage& t) { t.job.width = 8191; }},
    {"a window of one pixel", ErrNone, [](TestImage& t) { t.job.x0 = 32, t.job.y0 = 16; }},
    {"empty window in x", ErrRegister, [](TestImage& t) { t.job.x0 = 33; }},
    {"empty window in y", ErrRegister, [](TestImage& t) { t.job.y0 = 17; }},
    {"inverted window", ErrRegister, [](TestImage& t) { t.job.x0 = 5, t.job.x1 = 4; }},
    {"window too wide", ErrRegister, [](TestImage& t) { t.job.x1 = 34; }},
    {"window too high", ErrRegister, [](TestImage& t) { t.job.y1 = 18; }},
    {"image unaligned", ErrRegister, [](TestImage& t) { t.job.image += 128; }},
    {"frame unaligned", ErrRegister, [](TestImage& t) { t.job.frame += 32; }},
    {"hits unaligned", ErrRegister, [](TestImage& t) { t.job.hits += 32; }},
    {"hits unaligned, not wanted", ErrNone, [](TestImage& t) { t.job.hits += 32, t.job.want_hits = 0; }},
    {"image to the last byte", ErrNone, [](TestImage& t) { t.job.image = kSpace - kImageBytes; }},
    {"image past the end", ErrRegister, [](TestImage& t) { t.job.image = kSpace - kImageBytes, t.job.image_bytes += 1; }},
    {"frame to the last byte", ErrNone, [](TestImage& t) { t.job.frame = kSpace - 192 * 17; }},
    {"frame past the end", ErrRegister, [](TestImage& t) { t.job.frame = kSpace - 192 * 17 + 64; }},
    {"hits past the end", ErrRegister, [](TestImage& t) { t.job.hits = kSpace - 17920, t.job.hits_bytes = 17921; }},
    {"hits past the end, not wanted", ErrNone, [](TestImage& t) { t.job.hits = kSpace - 64, t.job.want_hits = 0; }},
    {"no room for the header", ErrRegister, [](TestImage& t) { t.job.image_bytes = 255; }},
    {"a list", ErrNone, [](TestImage& t) { make_list(t); }},
    {"an empty list", ErrRegister, [](TestImage& t) { make_list(t, 0); }},
    {"the longest list", ErrNone, [](TestImage& t) { make_list(t, MaxRays); }},
    {"a list too long", ErrRegister, [](TestImage& t) { make_list(t, MaxRays + 1); }},
    {"rays unaligned", ErrRegister, [](TestImage& t) { make_list(t), t.job.rays += 32; }},
    {"rays to the last byte", ErrNone, [](TestImage& t) { make_list(t), t.job.rays = kSpace - t.job.ray_bytes; }},
    {"rays past the end", ErrRegister, [](TestImage& t) { make_list(t), t.job.rays = kSpace - t.job.ray_bytes + 64; }},
    {"rays unaligned, of a frame", ErrNone, [](TestImage& t) { t.job.rays += 32, t.job.ray_count = 0; }},
    {"hits of a list unaligned", ErrRegister, [](TestImage& t) { make_list(t), t.job.hits += 32; }},
};

}  // namespace castray::tb
