// SPDX-License-Identifier: Apache-2.0
#include "probe.hpp"

namespace castray::sim {
namespace {

Probe* attached = nullptr;
bool muted = false;

// Adds an item to its list, unless it is of another pixel or context.
template <class Record> Record& add(std::vector<Record>& list, const std::uint32_t* words) {
  return list.emplace_back(unpack<Record>(words));
}
template <class Record, class Ours> void add_if(std::vector<Record>& list, const std::uint32_t* words, Ours&& ours) {
  if (ours(add(list, words))) return;
  list.pop_back();
}

// The context's number in front of an item.
template <class Record> ctx_t ctx_of(const std::uint32_t* words) { return get_bits(words, Record::kBits, CtxW); }

}  // namespace

Probe::Attached::Attached(Probe& probe) { attached = &probe; }
Probe::Attached::~Attached() { attached = nullptr; }
Probe::Muted::Muted() { muted = true; }
Probe::Muted::~Muted() { muted = false; }

void Probe::enter(ctx_t ctx, const pixel_tag_t& tag) {
  if (is_pixel(tag)) ctx_ = ctx;
  else if (ctx_ == ctx) ctx_.reset();
}

void Probe::take(int stream, const std::uint32_t* words) {
  const auto of_pixel = [&](const auto& item) { return is_pixel(item.tag); };
  const auto of_ctx = [&](const auto& item) { return ctx_ == item.ctx; };
  switch (stream) {
    case 0:
      if (corners_ > 0) return static_cast<void>(--corners_);
      return add_if(directions, words, of_pixel);
    case 1: return add_if(rays, words, of_pixel);
    case 2: return add_if(candidates, words, of_ctx);
    case 3: return add_if(results, words, of_ctx);
    case 4: return add_if(hits, words, of_pixel);
    case 5: return add_if(shaded, words, of_pixel);
    case 6: return enter(ctx_of<pixel_tag_t>(words), unpack<pixel_tag_t>(words));
    case 7:
      if (ctx_ == ctx_of<ref_t>(words)) visits.push_back({unpack<ref_t>(words), {}});
      return;
    case 8:
      if (ctx_ == ctx_of<visits_t>(words) && !visits.empty()) visits.back().children = unpack<visits_t>(words);
      return;
    case 9:
      if (ctx_ == ctx_of<prim_slot_t>(words)) add(tests, words);
      return;
    case 10: return static_cast<void>(add(bounds, words));
    case 11: return reads.push_back(static_cast<line_t>(get_bits(words, 0, line_t_bits)));
    case 12: return static_cast<void>(add(frontier, words));
    case 13: return static_cast<void>(add(started, words));
  }
}

}  // namespace castray::sim

// The DPI functions of stream_probe.sv.
extern "C" unsigned char castray_probing() { return castray::sim::attached && !castray::sim::muted; }

extern "C" void castray_probe(int stream, const std::uint32_t* words) {
  if (castray_probing()) castray::sim::attached->take(stream, words);
}
