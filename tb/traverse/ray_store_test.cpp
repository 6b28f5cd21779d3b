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
  // Three reads in one cycle, of which nobody reads another's context.
  void expect(int test_ctx, const ray_t& test, int hit_ctx, const ray_t& hit, int out_ctx, const ray_t& out) {
    dut_->test_ctx_i = test_ctx, dut_->hit_ctx_i = hit_ctx, dut_->out_ctx_i = out_ctx;
    dut_.settle();
    EXPECT_EQ(to_text(get_port<test_ray_t>(dut_->test_ray_o)), to_text(test_ray_of(test)));
    EXPECT_EQ(dut_->test_valid_o, test.valid);
    EXPECT_EQ(dut_->test_ignore_o, test.ignore);
    EXPECT_EQ(to_text(get_port<hit_ray_t>(dut_->hit_ray_o)), to_text(hit_ray_of(hit)));
    EXPECT_EQ(to_text(get_port<pixel_tag_t>(dut_->out_tag_o)), to_text(out.tag));
    EXPECT_EQ(get_signed(dut_->out_sx_o, shear_t_bits), out.sx);
    EXPECT_EQ(get_signed(dut_->out_sy_o, shear_t_bits), out.sy);
    EXPECT_EQ(dut_->out_axis_o, out.axis);
    EXPECT_EQ(dut_->out_neg_o, out.neg);
  }
  Dut<Vray_store> dut_;
};

TEST_F(RayStore, KeepsEveryFlagInItsPlace) {
  for (int flags = 0; flags < 8; ++flags) {
    ray_t ray;
    ray.valid = flags & 1, ray.cull = flags >> 1 & 1, ray.neg = flags >> 2 & 1;
    write(3, ray);
    dut_.tick();
    expect(3, ray, 3, ray, 3, ray);
  }
}

TEST_F(RayStore, AWriteIsSeenInTheNextCycle) {
  std::mt19937_64 rng(1);
  const ray_t old = random_ray(rng), fresh = random_ray(rng);
  write(4, old);
  dut_.tick();
  write(4, fresh);
  expect(4, old, 4, old, 4, old);
  dut_.tick();
  dut_->write_i = 0;
  expect(4, fresh, 4, fresh, 4, fresh);
}

TEST_F(RayStore, WritesOnlyWhenTold) {
  std::mt19937_64 rng(2);
  const ray_t kept = random_ray(rng);
  write(0, kept);
  dut_.tick();
  write(0, random_ray(rng));
  dut_->write_i = 0;
  dut_.tick();
  expect(0, kept, 0, kept, 0, kept);
}

TEST_F(RayStore, ServesThreeContextsAtOnce) {
  std::mt19937_64 rng(3);
  std::vector<ray_t> rays(kContexts);
  for (int ctx = 0; ctx < kContexts; ++ctx, dut_.tick()) write(ctx, rays[ctx] = random_ray(rng));
  for (int i = 0; i < 20000 && !HasFailure(); ++i) {
    const int test = rng() % kContexts, hit = rng() % kContexts, out = rng() % kContexts, written = rng() % kContexts;
    const ray_t fresh = random_ray(rng);
    write(written, fresh);
    dut_->write_i = rng() % 2;
    expect(test, rays[test], hit, rays[hit], out, rays[out]);
    if (dut_->write_i) rays[written] = fresh;
    dut_.tick();
  }
}

}  // namespace
}  // namespace castray::tb
