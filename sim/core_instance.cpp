// SPDX-License-Identifier: Apache-2.0
// The shared object of one build variant: compiled against that variant's Verilated class.
#include "core_instance.hpp"

#include "Vcastray_core.h"

extern "C" __attribute__((visibility("default"))) castray::sim::CoreModel* castray_make_core(std::uint64_t seed) {
  return new castray::sim::CoreInstance<Vcastray_core>(seed);
}
