// SPDX-License-Identifier: Apache-2.0
// What records of a list ask for: seeded ones near every limit, and each way to be no ray by name.
#include "mem/ray_request.hpp"

#include "Vray_request.h"
#include "dut.hpp"

namespace castray::tb {
namespace {

constexpr std::int64_t kCompMax = (std::int64_t{1} << (dir_comp_t_bits - 1)) - 1;

class RayRequest : public testing::Test {
 protected:
  // The request, equal to the model's.
  ray_req_t request(const ray_record_t& record, std::uint64_t number = 0) {
    set_port(dut_->record_i, record);
    dut_->number_i = number;
    dut_->eval();
    const ray_req_t got = get_port<ray_req_t>(dut_->req_o);
    EXPECT_EQ(to_text(got), to_text(ray_request(record, number))) << to_text(record);
    EXPECT_EQ(dut_->legal_o, ray_flags_ok(record));
    return got;
  }
  static ray_record_t plain() { return ray_record({.z = 3, .y = 2, .x = 1}, {.z = -7, .y = 6, .x = 5}); }
  VerilatedContext context_;
  std::unique_ptr<Vray_request> dut_ = std::make_unique<Vray_request>(&context_);
};

TEST_F(RayRequest, TakesARayAsItIs) {
  const ray_req_t req = request(plain(), 0xabc123);
  EXPECT_TRUE(req.ok);
  EXPECT_EQ(req.tag.x, 0x123u);
  EXPECT_EQ(req.tag.y, 0xabcu);
  EXPECT_EQ(req.tmin, 0);
  EXPECT_EQ(req.tmax, TMax);
  EXPECT_EQ(req.ignore, static_cast<prim_t>(NoPrim));
  EXPECT_EQ(req.cull | req.any_hit, 0u);
  EXPECT_TRUE(dut_->legal_o);
}

TEST_F(RayRequest, KnowsItsFlags) {
  ray_record_t record = plain();
  for (unsigned bit = 0; bit < 32; ++bit) {
    record.flags = 1u << bit;
    const ray_req_t req = request(record);
    EXPECT_EQ(req.any_hit, bit == RayAnyHit);
    EXPECT_EQ(req.cull, bit == RayCull);
    EXPECT_EQ(dut_->legal_o, bit < NumRayFlags) << bit;
  }
}

TEST_F(RayRequest, AnOriginOutsideTheGridIsNone) {
  for (auto field : {&ray_record_t::org_x, &ray_record_t::org_y, &ray_record_t::org_z}) {
    ray_record_t record = plain();
    record.*field = (1u << CoordW) - 1;
    EXPECT_TRUE(request(record).ok);
    for (unsigned bit = CoordW; bit < 32; ++bit) {
      record.*field = 1u << bit;
      EXPECT_FALSE(request(record).ok) << bit;
    }
  }
}

TEST_F(RayRequest, ADirectionBeyondTheFormatIsNone) {
  for (auto field : {&ray_record_t::dir_x, &ray_record_t::dir_y, &ray_record_t::dir_z}) {
    ray_record_t record = plain();
    for (const auto& [component, ok] : {std::pair{kCompMax, true}, {-kCompMax - 1, true}, {kCompMax + 1, false}, {-kCompMax - 2, false}}) {
      record.*field = component;
      EXPECT_EQ(request(record).ok, ok) << component;
    }
    for (unsigned bit = dir_comp_t_bits; bit < 64; ++bit) {
      record.*field = static_cast<std::int64_t>(std::uint64_t{1} << bit);
      EXPECT_FALSE(request(record).ok) << bit;
    }
  }
}

TEST_F(RayRequest, ARangeIsClampedAndMayBeEmpty) {
  struct Range {
    std::int64_t tmin, tmax;
    bool ok;
  };
  constexpr std::int64_t kMost = (std::int64_t{1} << 31) - 1;
  for (const Range& range : {Range{0, 1, true}, {1, 1, false}, {2, 1, false}, {-1, 0, false}, {-kMost - 1, 1, true}, {-5, -3, false},
                             {TMax - 1, TMax, true}, {TMax - 1, TMax + 1, true}, {TMax, TMax + 1, false}, {TMax + 1, kMost, false},
                             {0, kMost, true}, {0, -kMost - 1, false}, {5, -1, false}}) {
    ray_record_t record = plain();
    record.tmin = range.tmin, record.tmax = range.tmax;
    EXPECT_EQ(request(record).ok, range.ok) << range.tmin << " " << range.tmax;
  }
}

TEST_F(RayRequest, IgnoresNoneOfTheNumbersThatCannotBe) {
  for (const std::uint64_t number : {std::uint64_t(0), std::uint64_t(77), std::uint64_t(NoPrim - 1), std::uint64_t(NoPrim), std::uint64_t(NoPrim + 1),
                                     std::uint64_t(NoHit), std::uint64_t(0x80000001)}) {
    ray_record_t record = plain();
    record.ignore = number;
    EXPECT_EQ(request(record).ignore, std::min<std::uint64_t>(number, NoPrim));
  }
}

TEST_F(RayRequest, MatchesTheModelOnSeededRecords) {
  std::mt19937_64 rng(5);
  int ok = 0;
  for (int i = 0; i < 50000; ++i) {
    const auto coord = [&] { return rng() % 8 ? rng() & 0x3ffffff : rng() >> (32 + rng() % 8); };
    const auto component = [&] { return static_cast<std::int64_t>(rng()) >> (rng() % 8 ? 19 + rng() % 44 : rng() % 24); };
    const auto t = [&] { return static_cast<std::int64_t>(static_cast<std::int32_t>(rng())) >> rng() % 3; };
    ray_record_t record;
    record.org_x = coord(), record.org_y = coord(), record.org_z = coord();
    record.dir_x = component(), record.dir_y = component(), record.dir_z = component();
    record.tmin = t(), record.tmax = rng() % 8 ? t() : record.tmin;
    record.flags = rng() % 8 ? rng() % 4 : rng() >> 32;
    record.ignore = rng() >> (32 + rng() % 16);
    ok += request(record, rng() & 0xffffff).ok;
  }
  EXPECT_GT(ok, 5000);
  EXPECT_LT(ok, 45000);
}

}  // namespace
}  // namespace castray::tb
