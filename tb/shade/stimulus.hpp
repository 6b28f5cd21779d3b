// SPDX-License-Identifier: Apache-2.0
// Random hits and attributes for the tests of shading.
#pragma once
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "dut.hpp"
#include "shade/interpolate.hpp"

namespace castray::tb {

class Stimulus {
 public:
  explicit Stimulus(unsigned seed) : rng_(seed) {}

  std::uint64_t bits(int count) { return rng_() & ((std::uint64_t{1} << count) - 1); }
  // Signed, of `count` bits, often small or at an end of its range.
  std::int64_t number(int count) {
    const std::int64_t top = (std::int64_t{1} << (count - 1)) - 1;
    switch (bits(3)) {
      case 0: return top - static_cast<std::int64_t>(bits(1));
      case 1: return -top - static_cast<std::int64_t>(bits(1));
      case 2: return static_cast<std::int64_t>(bits(2)) - 2;
      default: return wrap_signed(static_cast<std::int64_t>(rng_()), count);
    }
  }
  unit3_t unit() {
    unit3_t n;
    n.x = number(unit_t_bits), n.y = number(unit_t_bits), n.z = number(unit_t_bits);
    return n;
  }
  point_t point() {
    point_t p;
    p.x = bits(CoordW), p.y = bits(CoordW), p.z = bits(CoordW);
    return p;
  }
  attr_t attr() {
    attr_t a;
    a.na = unit(), a.nb = unit(), a.nc = unit(), a.face = unit();
    a.sa = number(27), a.sb = number(27), a.sc = number(27);
    a.ta = number(27), a.tb = number(27), a.tc = number(27);
    if (bits(4) == 0) a.na = a.nb = a.nc = unit3_t{};
    a.centre = point();
    a.material = bits(2);
    return a;
  }
  hit_t hit() {
    hit_t h;
    h.tag.x = bits(12), h.tag.y = bits(12), h.tag.slot = bits(8);
    h.found = 1;
    h.kind = bits(1);
    h.number = bits(PrimW);
    h.t = wrap_signed(static_cast<std::int64_t>(rng_()), t_t_bits) >> bits(5);
    const std::int64_t one = std::int64_t{1} << BaryFrac;
    h.u = bits(3) == 0 ? (bits(1) ? one : 0) : bits(24);
    h.v = one - static_cast<std::int64_t>(h.u) == 0 ? 0 : rng_() % (one - h.u + 1);
    h.sx = number(ShearFrac + 1);
    h.sy = number(ShearFrac + 1);
    h.axis = rng_() % 3;
    h.neg = bits(1);
    return h;
  }
  shade_req_t request() {
    shade_req_t r;
    r.hit = hit();
    r.attr = attr();
    return r;
  }
  std::vector<shade_req_t> requests(int count) {
    std::vector<shade_req_t> list;
    for (int i = 0; i < count; ++i) list.push_back(request());
    return list;
  }

 private:
  std::mt19937_64 rng_;
};

template <class Out> void expect_equal(const std::vector<Out>& got, const std::vector<Out>& want) {
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    if (got[i] == want[i]) continue;
    ADD_FAILURE() << "item " << i << "\n  got  " << to_text(got[i]) << "\n  want " << to_text(want[i]);
    return;
  }
}

// How many inputs a unit takes while its output is shut.
template <class V, class In> int taken_while_blocked(Dut<V>& dut, const In& input, int cycles = 400) {
  int taken = 0;
  dut->out_ready_i = 0;
  dut->in_valid_i = 1;
  set_port(dut->in_i, input);
  for (int i = 0; i < cycles; ++i) {
    dut.settle();
    taken += dut->in_ready_o;
    dut.tick();
  }
  dut->in_valid_i = 0;
  return taken;
}

}  // namespace castray::tb
