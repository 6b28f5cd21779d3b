// SPDX-License-Identifier: Apache-2.0
// Records of hits and misses, and where they are written.
#include "mem/hit_writer.hpp"

#include "Vhit_writer.h"
#include "dut.hpp"
#include "mem/image.hpp"

namespace castray::tb {
namespace {

constexpr std::uint64_t kBase = 0x80'1234'5600;

write_req_t request_of(const cast_t& cast, std::uint64_t base, std::uint64_t width, bool work) {
  write_req_t req;
  req.addr = (base + hit_offset(cast.hit.tag, width)) & ((std::uint64_t{1} << AddrW) - 1);
  req.beats = 2;
  req.strb = 0xffffffff;
  store_record(reinterpret_cast<std::uint8_t*>(req.data.data()), hit_record(cast.hit, work ? cast.work : work_t{}));
  return req;
}

class HitWriter : public testing::TestWithParam<Stalls> {
 protected:
  void compare(const std::vector<cast_t>& casts, std::uint64_t base, std::uint64_t width, bool work, Stalls stalls = {}) {
    dut_->want_work_i = work;
    dut_->base_i = base;
    dut_->width_i = width;
    const auto got = run_stream<write_req_t>(dut_, casts, casts.size(), stalls, 3);
    ASSERT_EQ(got.size(), casts.size());
    for (std::size_t i = 0; i < casts.size(); ++i)
      ASSERT_EQ(to_text(got[i]), to_text(request_of(casts[i], base, width, work))) << to_text(casts[i]);
  }
  Dut<Vhit_writer> dut_;
};

cast_t random_cast(std::mt19937_64& rng) {
  cast_t cast;
  hit_t& h = cast.hit;
  h.found = rng() & 1, h.any_hit = rng() & 1;
  h.tag.x = rng() & 4095, h.tag.y = rng() & 4095;
  h.number = rng() & static_cast<std::uint64_t>(NoPrim);
  h.t = wrap_signed(static_cast<std::int64_t>(rng()), t_t_bits);
  h.u = rng() & 0x1ffffff, h.v = rng() & 0x1ffffff;
  h.sx = -5, h.kind = rng() & 1;
  cast.work.nodes = rng() & 0xffffff, cast.work.tests = rng() & 0x7ffffff;
  return cast;
}

TEST_P(HitWriter, MatchesModel) {
  std::mt19937_64 rng(1);
  for (const std::uint64_t width : {1, 33, 320, 4096}) {
    std::vector<cast_t> casts;
    for (int i = 0; i < 3000; ++i) casts.push_back(random_cast(rng));
    compare(casts, kBase, width, width != 33, GetParam());
  }
}
INSTANTIATE_TEST_SUITE_P(Stalls, HitWriter, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(HitWriter, WritesAMissAsAllOnesAtTMax) {
  hit_t miss;
  miss.t = 123, miss.u = 4, miss.v = 5, miss.number = 6;
  dut_->base_i = 0;
  dut_->width_i = 1;
  const auto got = run_stream<write_req_t>(dut_, std::vector<cast_t>{{.hit = miss}}, 1);
  ASSERT_EQ(got.size(), 1u);
  const std::uint32_t want[8] = {0x3fffffff, 0, 0, 0xffffffff, 0xffffffff, 0, 0, 0};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(got[0].data[i], want[i]) << i;
  for (int i = 8; i < 16; ++i) EXPECT_EQ(got[0].data[i], 0u) << i;
}

TEST_F(HitWriter, SaysOfAnyHitOnlyThatItIsOne) {
  dut_->base_i = 0;
  dut_->width_i = 1;
  for (const bool found : {false, true}) {
    hit_t any;
    any.any_hit = 1, any.found = found;
    any.t = 123, any.u = 4, any.v = 5, any.number = 6;
    const auto got = run_stream<write_req_t>(dut_, std::vector<cast_t>{{.hit = any}}, 1);
    ASSERT_EQ(got.size(), 1u);
    const std::uint32_t yes[8] = {0, 0, 0, 0xfffffffe, 0, 0, 0, 0}, no[8] = {0x3fffffff, 0, 0, 0xffffffff, 0xffffffff, 0, 0, 0};
    for (int i = 0; i < 8; ++i) EXPECT_EQ(got[0].data[i], found ? yes[i] : no[i]) << i;
  }
}

TEST_F(HitWriter, KeepsEveryExtreme) {
  cast_t cast;
  hit_t& hit = cast.hit;
  cast.work.nodes = 0xffffff, cast.work.tests = 0x7ffffff;
  hit.found = 1;
  hit.t = -TMax - 1, hit.u = hit.v = std::uint64_t{1} << BaryFrac, hit.number = NoPrim - 1;
  dut_->base_i = 0;
  dut_->width_i = 1;
  dut_->want_work_i = 1;
  const auto got = run_stream<write_req_t>(dut_, std::vector<cast_t>{cast}, 1);
  ASSERT_EQ(got.size(), 1u);
  const std::uint32_t want[8] = {0xc0000000, 1u << 24, 1u << 24, (1u << 21) - 2, 0, 0xffffff, 0x7ffffff, 0};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(got[0].data[i], want[i]) << i;
}

TEST_F(HitWriter, ReachesTheLastPixelOfTheLargestFrame) {
  cast_t cast;
  cast.hit.tag.x = cast.hit.tag.y = 4095;
  compare({cast}, (std::uint64_t{1} << 40) - (std::uint64_t{32} << 24), 4096, false);
  EXPECT_EQ(request_of(cast, (std::uint64_t{1} << 40) - (std::uint64_t{32} << 24), 4096, false).addr, (std::uint64_t{1} << 40) - 32);
}

TEST_F(HitWriter, TakesOneACycleAndFillsItsStages) {
  const long before = dut_.cycles();
  run_stream<write_req_t>(dut_, std::vector<cast_t>(300), 300);
  EXPECT_LE(dut_.cycles() - before, 300 + 4);
  dut_->out_ready_i = 0;
  dut_->in_valid_i = 1;
  int taken = 0;
  for (int i = 0; i < 20; ++i) {
    dut_.settle();
    taken += dut_->in_ready_o;
    dut_.tick();
  }
  EXPECT_EQ(taken, 3);
}

TEST_F(HitWriter, IsIdleWhenEveryRecordHasLeft) {
  dut_->in_valid_i = dut_->out_ready_i = 0;
  dut_.settle();
  EXPECT_TRUE(dut_->idle_o);
  dut_->in_valid_i = 1;
  for (int i = 0; i < 2; ++i) dut_.tick();
  dut_->in_valid_i = 0;
  for (int i = 0; i < 9; ++i) {
    EXPECT_FALSE(dut_->idle_o);
    dut_.tick();
  }
  dut_->out_ready_i = 1;
  dut_.tick();
  EXPECT_FALSE(dut_->idle_o) << "one record is still inside";
  dut_.tick();
  EXPECT_TRUE(dut_->idle_o);
}

}  // namespace
}  // namespace castray::tb
