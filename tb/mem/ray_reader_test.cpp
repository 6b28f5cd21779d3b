// SPDX-License-Identifier: Apache-2.0
// ray_reader against the model of its records, over a read client with latency, gaps and refusals.
#include "Vray_reader.h"
#include "dut.hpp"
#include "mem/ray_request.hpp"

namespace castray::tb {
namespace {

constexpr int kDepth = 32;                       // rays in the queue
constexpr std::uint64_t kPage = 0xff'1234'5000;  // of memory

std::vector<ray_record_t> random_list(std::uint64_t rays, unsigned seed) {
  std::mt19937_64 rng(seed);
  std::vector<ray_record_t> list(rays);
  for (ray_record_t& ray : list) {
    packed_t<ray_record_t> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(rng());
    ray = unpack<ray_record_t>(words.data());
    ray.flags &= 3;
    if (rng() % 4) ray.org_x >>= 6, ray.org_y >>= 6, ray.org_z >>= 6, ray.dir_x >>= 20, ray.dir_y >>= 20, ray.dir_z >>= 20;
  }
  return list;
}

class RayReader : public ::testing::TestWithParam<Stalls> {
 protected:
  struct Beat {
    long due;
    read_rsp_t rsp;
  };

  void start(const std::vector<ray_record_t>& list, std::uint64_t base) {
    base_ = base, next_ = 0, asked_ = faults_ = 0;
    bytes_.resize(list.size() * RayBytes);
    for (std::size_t i = 0; i < list.size(); ++i) store_record(&bytes_[i * RayBytes], list[i]);
    beats_.clear();
    dut->base_i = base;
    dut->count_i = static_cast<std::uint32_t>(list.size());
    dut->start_i = 1;
    dut->req_ready_i = dut->rsp_valid_i = dut->out_ready_i = 0;
    dut.tick();
    dut->start_i = 0;
  }

  // One cycle; rays that were taken go to `got`.
  void cycle(bool grant, bool respond, bool take, long latency, std::vector<ray_req_t>& got) {
    dut->req_ready_i = grant;
    dut->out_ready_i = take;
    dut->rsp_valid_i = respond && !beats_.empty() && beats_.front().due <= dut.cycles();
    if (dut->rsp_valid_i) {
      set_port(dut->rsp_i, beats_.front().rsp);
      beats_.pop_front();
    }
    dut.settle();
    faults_ += dut->fault_o == ErrRay;
    if (dut->req_valid_o && grant) {
      const auto req = get_port<read_req_t>(dut->req_o);
      ASSERT_EQ(req.addr, base_ + next_) << "records are asked for once, in order";
      ASSERT_TRUE(req.beats >= 4 && req.beats <= 16 && req.beats % 4 == 0);
      ASSERT_EQ(req.addr / 4096, (req.addr + req.beats * 16 - 1) / 4096) << "a burst over a page";
      ASSERT_LE(next_ + req.beats * 16, bytes_.size()) << "beyond the list";
      for (std::uint64_t i = 0; i < req.beats; ++i) {
        Beat beat{dut.cycles() + latency, {}};
        std::memcpy(beat.rsp.data.data(), &bytes_[next_ + 16 * i], 16);
        beat.rsp.last = i + 1 == req.beats;
        beats_.push_back(beat);
      }
      next_ += req.beats * 16;
      asked_ += static_cast<long>(req.beats) / 4;
    }
    if (dut->out_valid_o && take) got.push_back(get_port<ray_req_t>(dut->out_o));
    dut.tick();
    dut.settle();
  }

  void expect_model(const std::vector<ray_record_t>& list, std::uint64_t base, Stalls stalls = {}, long latency = 60) {
    Gate grant(stalls.source, stalls.burst, 1), respond(stalls.source, stalls.burst, 2), take(stalls.sink, stalls.burst, 3);
    std::vector<ray_req_t> got;
    start(list, base);
    cycles_ = 0;
    for (const long limit = 5000 + 80 * static_cast<long>(list.size()); cycles_ < limit && !dut->done_o; ++cycles_)
      ASSERT_NO_FATAL_FAILURE(cycle(grant.open(), respond.open(), take.open(), latency, got));
    EXPECT_TRUE(dut->done_o);
    EXPECT_FALSE(dut->out_valid_o);
    EXPECT_TRUE(beats_.empty());
    EXPECT_EQ(faults_, 0);
    ASSERT_EQ(got.size(), list.size());
    for (std::size_t i = 0; i < got.size(); ++i) ASSERT_EQ(to_text(got[i]), to_text(ray_request(list[i], i))) << i;
  }

  Dut<Vray_reader> dut;
  std::vector<std::uint8_t> bytes_;
  std::deque<Beat> beats_;
  std::uint64_t base_ = 0, next_ = 0;
  long faults_ = 0, asked_ = 0, cycles_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Stalls, RayReader, ::testing::ValuesIn(kStallPatterns));

// From each place of a record among a burst's four.
TEST_P(RayReader, MatchesModel) {
  unsigned seed = 1;
  for (const std::uint64_t rays : {1u, 2u, 3u, 4u, 5u, 8u, 67u, 300u})
    for (std::uint64_t first = 0; first < 4; ++first)
      for (const long latency : {0L, 60L}) expect_model(random_list(rays, ++seed), kPage + 64 * first, GetParam(), latency);
}

TEST_F(RayReader, KeepsInsidePages) {
  for (std::uint64_t first = 60; first < 64; ++first) expect_model(random_list(9, 3), kPage + 64 * first);
}

TEST_F(RayReader, EndsWithTheAddressSpace) {
  const std::uint64_t base = (std::uint64_t{1} << AddrW) - 5 * RayBytes;
  expect_model(random_list(5, 4), base);
}

TEST_F(RayReader, ReportsFlagsThatAreNone) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    std::vector<ray_record_t> list = random_list(6, bit);
    list[3].flags = 1u << bit;
    std::vector<ray_req_t> got;
    start(list, kPage);
    for (int i = 0; i < 100; ++i) cycle(true, true, true, 3, got);
    EXPECT_EQ(faults_, bit >= NumRayFlags) << bit;
  }
}

TEST_F(RayReader, AsksForNoMoreThanItCanHold) {
  const auto list = random_list(100, 7);
  std::vector<ray_req_t> got;
  start(list, kPage);
  for (int i = 0; i < 500; ++i) cycle(true, true, false, 3, got);
  EXPECT_EQ(asked_, kDepth);
  EXPECT_TRUE(beats_.empty());
  EXPECT_FALSE(dut->req_valid_o);
  for (int i = 0; i < 3; ++i) cycle(true, true, true, 3, got);   // a burst's places must be free before it is asked for
  for (int i = 0; i < 20; ++i) cycle(true, true, false, 3, got);
  EXPECT_EQ(asked_, kDepth);
  cycle(true, true, true, 3, got);
  for (int i = 0; i < 20; ++i) cycle(true, true, false, 3, got);
  EXPECT_EQ(asked_, kDepth + 4);
  EXPECT_FALSE(dut->done_o);
  for (int i = 0; i < 2000 && !dut->done_o; ++i) cycle(true, true, true, 3, got);
  ASSERT_EQ(got.size(), list.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_TRUE(got[i] == ray_request(list[i], i)) << i;
}

TEST_F(RayReader, GivesARayEveryFourCyclesAtALatencyOf100) {
  expect_model(random_list(1000, 8), kPage, {}, 100);
  EXPECT_LE(cycles_, 4000 + 120);
}

TEST_F(RayReader, IsNotDoneBeforeItsFirstStartAndForgetsAtReset) {
  EXPECT_FALSE(dut->done_o);
  const auto list = random_list(60, 9);
  for (int at = 1; at < 120; at += 7) {
    std::vector<ray_req_t> got;
    start(list, kPage);
    for (int i = 0; i < at; ++i) cycle(true, true, i % 3 == 0, 4, got);
    dut->rsp_valid_i = 0;
    dut.reset();
    EXPECT_FALSE(dut->done_o || dut->req_valid_o || dut->out_valid_o);
    expect_model(list, kPage);
  }
}

}  // namespace
}  // namespace castray::tb
