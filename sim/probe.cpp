// SPDX-License-Identifier: Apache-2.0
#include "probe.hpp"

namespace {
castray::sim::Probe* attached = nullptr;
bool muted = false;

template <class Record> void add(std::vector<Record>& list, const std::uint32_t* words) {
  list.push_back(castray::unpack<Record>(words));
}
}  // namespace

namespace castray::sim {
Probe::Attached::Attached(Probe& probe) { attached = &probe; }
Probe::Attached::~Attached() { attached = nullptr; }
Probe::Muted::Muted() { muted = true; }
Probe::Muted::~Muted() { muted = false; }
}  // namespace castray::sim

// The DPI functions of stream_probe.sv.
extern "C" unsigned char castray_probing() { return attached && !muted; }

extern "C" void castray_probe(int stream, const std::uint32_t* words) {
  if (!castray_probing()) return;
  switch (stream) {
    case 0: return add(attached->directions, words);
    case 1: return add(attached->rays, words);
    case 2: return add(attached->candidates, words);
    case 3: return add(attached->results, words);
    case 4: return add(attached->hits, words);
    case 5: return add(attached->shaded, words);
  }
}
