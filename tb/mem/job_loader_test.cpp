// SPDX-License-Identifier: Apache-2.0
// The job loader: one burst, then the same verdict as the model on every spoilt image.
#include "Vjob_loader.h"
#include "dut.hpp"
#include "test_image.hpp"

namespace castray::tb {

class JobLoader : public testing::TestWithParam<Stalls> {
 protected:
  // Runs a job against the bytes; returns the error, or -1 if it did not end.
  int run(const TestImage& image, Stalls stalls = {}, unsigned seed = 1) {
    Gate source(stalls.source, stalls.burst, seed), sink(stalls.sink, stalls.burst, seed + 1);
    const std::vector<std::uint8_t> bytes = image.bytes();
    set_port(dut_->job_i, image.job);
    dut_->start_i = 1;
    unsigned sent = 16;
    requests_ = 0;
    for (int cycle = 0; cycle < 2000; ++cycle) {
      dut_->req_ready_i = sink.open();
      dut_->rsp_valid_i = sent < 16 && source.open();
      if (dut_->rsp_valid_i) {
        read_rsp_t rsp;
        std::memcpy(rsp.data.data(), bytes.data() + 16 * sent, 16);
        rsp.last = sent == 15;
        set_port(dut_->rsp_i, rsp);
        ++sent;
      }
      dut_.settle();
      if (cycle > 0 && dut_->done_o) {
        EXPECT_EQ(requests_, 1);
        return static_cast<int>(dut_->error_o);
      }
      if (dut_->req_valid_o && dut_->req_ready_i) {
        const read_req_t req = get_port<read_req_t>(dut_->req_o);
        EXPECT_EQ(req.addr, image.job.image);
        EXPECT_EQ(req.beats, 16u);
        ++requests_;
        sent = 0;
      }
      dut_.tick();
      ++cycles_;
      dut_->start_i = 0;
    }
    return -1;
  }
  void quiet() { dut_->start_i = dut_->rsp_valid_i = dut_->req_ready_i = 0; }
  void SetUp() override {
    quiet();
    dut_.reset();
  }

  Dut<Vjob_loader> dut_;
  int requests_ = 0;
  long cycles_ = 0;
};

TEST_P(JobLoader, GivesTheModelsVerdictOnEveryDefect) {
  unsigned seed = 0;
  for (const Defect& defect : kRecordDefects) {
    TestImage image;
    defect.spoil(image);
    EXPECT_EQ(check_records(image.header, image.frame, image.job), defect.error) << "the model: " << defect.name;
    EXPECT_EQ(run(image, GetParam(), seed += 2), defect.error) << defect.name;
    EXPECT_TRUE(get_port<image_header_t>(dut_->header_o) == image.header);
    EXPECT_TRUE(get_port<frame_record_t>(dut_->record_o) == image.frame);
  }
}
INSTANTIATE_TEST_SUITE_P(Stalls, JobLoader, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return info.param.name; });

// Any two at once: the earlier step's code.
TEST_F(JobLoader, FindsTheSameFirstDefectAsTheModel) {
  for (const Defect& first : kRecordDefects) {
    for (const Defect& second : kRecordDefects) {
      TestImage image;
      first.spoil(image);
      second.spoil(image);
      EXPECT_EQ(run(image), check_records(image.header, image.frame, image.job)) << first.name << ", " << second.name;
    }
  }
}

// Fields near their limits, all at once.
TEST_F(JobLoader, EqualsTheModelOnSeededImages) {
  std::mt19937_64 rng(7);
  std::map<int, int> seen;
  for (int round = 0; round < 20000; ++round) {
    TestImage image;
    const auto nudge = [&](std::uint64_t& field, std::uint64_t unit) {
      if (rng() % 12 == 0) field += unit * (rng() % 5) - 2 * unit;
      field &= 0xffffffff;
    };
    nudge(image.header.lines.count, 1 + rng() % 52);
    nudge(image.header.lines.offset, 128);
    nudge(image.header.attributes.count, 1);
    nudge(image.header.attributes.offset, 64);
    nudge(image.header.primitives, 1);
    nudge(image.header.image_bytes, 64);
    nudge(image.job.image_bytes, 1);
    image.job.width = image.frame.width = 1 + rng() % 4096;
    image.job.height = image.frame.height = 1 + rng() % 4096;
    image.frame.stride = (image.job.width * 4 + 63) / 64 * 64 + (rng() % 4 == 0 ? 64 * (rng() % 100000) : 0);
    image.job.frame_bytes = std::min<std::uint64_t>(image.frame.stride * image.job.height, 0xffffffff);
    image.job.hits_bytes = image.job.width * image.job.height * 32;
    nudge(image.frame.width, 1);
    image.frame.width &= 0xffff;
    nudge(image.frame.stride, 32);
    nudge(image.job.frame_bytes, 1);
    nudge(image.job.hits_bytes, 1);
    image.job.want_hits = rng() & 1;
    image.job.is_list = rng() % 4 == 0;
    if (image.job.is_list) {
      image.job.ray_count = rng() % 2 ? 1 + rng() % 100 : 1 + rng() % MaxRays;
      image.job.ray_bytes = image.job.ray_count * RayBytes + (rng() % 4 ? 0 : rng() % 3 - 1);
      image.job.hits_bytes = image.job.ray_count * HitBytes + (rng() % 4 ? 0 : rng() % 3 - 1);
    }
    const error_t expected = check_records(image.header, image.frame, image.job);
    ++seen[static_cast<int>(expected)];
    ASSERT_EQ(run(image), expected) << to_text(image.header) << "\n" << to_text(image.frame) << "\n" << to_text(image.job);
  }
  for (const error_t error : {ErrNone, ErrSection, ErrFrameRecord, ErrFrameWindow, ErrHitWindow, ErrRayWindow})
    EXPECT_GT(seen[static_cast<int>(error)], 100) << "too few to say anything about error " << error;
}

TEST_F(JobLoader, TakesSeventeenCyclesBesidesTheBurst) {
  cycles_ = 0;
  EXPECT_EQ(run({}), ErrNone);
  EXPECT_EQ(cycles_, 1 + 16 + 17 - 1);  // start, beats; asking and checking
}

TEST_F(JobLoader, IsUsableAfterAResetAtAnyCycle) {
  for (int cut = 1; cut < 36; ++cut) {
    TestImage bad;
    bad.header.magic = 0;
    set_port(dut_->job_i, bad.job);
    dut_->start_i = 1;
    for (int i = 0; i < cut; ++i) {
      dut_->req_ready_i = 1;
      dut_->rsp_valid_i = i >= 2 && i < 18;
      read_rsp_t rsp;
      rsp.last = i == 17;
      set_port(dut_->rsp_i, rsp);
      dut_.tick();
      dut_->start_i = 0;
    }
    quiet();
    dut_.reset(1);
    EXPECT_FALSE(dut_->done_o);
    EXPECT_FALSE(dut_->req_valid_o);
    EXPECT_EQ(run({}), ErrNone) << cut;
  }
}

}  // namespace castray::tb
