// SPDX-License-Identifier: Apache-2.0
// The rays of a lane's contexts: each reader sees its own context's fields, a write is seen a cycle later.
// Verilator: -GContexts=5
#include "traverse/ray_store.hpp"

#include "Vray_store.h"
#include "dut.hpp"
#include "signed_port.hpp"

namespace castray::tb {
namespace {

constexpr int kContexts = 5;

ray_t random_ray(std::mt19937_64& rng) {
  std::array<std::uint32_t, words_of<ray_t>> words;
  for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(rng());
  return unpack<ray_t>(words.data());
}

class RayStore : public testing::Test {
 protected:
  void write(int ctx, const ray_t& ray) {
    dut_->write_i = 1;
    dut_->write_ctx_i = ctx;
    set_port(dut_->ray_i, ray);
  }
  // What each reader sees of its context, all in one cycle.
  enum Reader { Test, Look, Node, Even, Odd, Hit, Out, kReaders };
  void expect(const std::array<int, kReaders>& ctx, const std::vector<ray_t>& rays) {
    const auto of = [&](Reader reader) -> const ray_t& { return rays[static_cast<std::size_t>(ctx[reader])]; };
    dut_->test_ctx_i = ctx[Test], dut_->look_ctx_i = ctx[Look], dut_->node_ctx_i = ctx[Node];
    dut_->step_ctx_i[0] = ctx[Even], dut_->step_ctx_i[1] = ctx[Odd], dut_->hit_ctx_i = ctx[Hit], dut_->out_ctx_i = ctx[Out];
    dut_.settle();
    const ray_t& out = of(Out);
    EXPECT_EQ(to_text(get_port<test_ray_t>(dut_->test_ray_o)), to_text(test_ray_of(of(Test))));
    EXPECT_EQ(dut_->look_valid_o, of(Look).valid);
    EXPECT_EQ(dut_->look_ignore_o, of(Look).ignore);
    EXPECT_EQ(to_text(get_port<slab_ray_t>(dut_->node_ray_o)), to_text(slab_ray_of(of(Node))));
    EXPECT_EQ(dut_->step_any_hit_o, of(Even).any_hit | of(Odd).any_hit << 1);
    EXPECT_EQ(to_text(get_port<hit_ray_t>(dut_->hit_ray_o)), to_text(hit_ray_of(of(Hit))));
    EXPECT_EQ(to_text(get_port<pixel_tag_t>(dut_->out_tag_o)), to_text(out.tag));
    EXPECT_EQ(get_signed(dut_->out_sx_o, shear_t_bits), out.sx);
    EXPECT_EQ(get_signed(dut_->out_sy_o, shear_t_bits), out.sy);
    EXPECT_EQ(dut_->out_axis_o, out.axis);
    EXPECT_EQ(dut_->out_neg_o, out.neg);
    EXPECT_EQ(dut_->out_any_hit_o, out.any_hit);
  }
  void expect(const ray_t& ray) { expect({}, {ray}); }
  Dut<Vray_store> dut_;
};

TEST_F(RayStore, KeepsEveryFlagInItsPlace) {
  for (int flags = 0; flags < 16; ++flags) {
    ray_t ray;
    ray.valid = flags & 1, ray.cull = flags >> 1 & 1, ray.neg = flags >> 2 & 1, ray.any_hit = flags >> 3;
    write(0, ray);
    dut_.tick();
    expect(ray);
  }
}

TEST_F(RayStore, AWriteIsSeenInTheNextCycle) {
  std::mt19937_64 rng(1);
  const ray_t old = random_ray(rng), fresh = random_ray(rng);
  write(0, old);
  dut_.tick();
  write(0, fresh);
  expect(old);
  dut_.tick();
  dut_->write_i = 0;
  expect(fresh);
}

TEST_F(RayStore, WritesOnlyWhenTold) {
  std::mt19937_64 rng(2);
  const ray_t kept = random_ray(rng);
  write(0, kept);
  dut_.tick();
  write(0, random_ray(rng));
  dut_->write_i = 0;
  dut_.tick();
  expect(kept);
}

TEST_F(RayStore, ServesAContextToEachReaderAtOnce) {
  std::mt19937_64 rng(3);
  std::vector<ray_t> rays(kContexts);
  for (int ctx = 0; ctx < kContexts; ++ctx, dut_.tick()) write(ctx, rays[ctx] = random_ray(rng));
  for (int i = 0; i < 20000 && !HasFailure(); ++i) {
    std::array<int, kReaders> readers;
    for (int& ctx : readers) ctx = rng() % kContexts;
    const int written = rng() % kContexts;
    const ray_t fresh = random_ray(rng);
    write(written, fresh);
    dut_->write_i = rng() % 2;
    expect(readers, rays);
    if (dut_->write_i) rays[written] = fresh;
    dut_.tick();
  }
}

}  // namespace
}  // namespace castray::tb
