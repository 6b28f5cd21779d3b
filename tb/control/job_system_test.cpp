// SPDX-License-Identifier: Apache-2.0
// Runs long.
// Registers, control, loader, reader, writer and counters together behind an AXI memory: whole
// jobs, errors and resets in mid-flight, and that the next job always works.
#include "../axi/axi_sub.hpp"
#include "../axi/lite_bus.hpp"
#include "../mem/test_image.hpp"
#include "Vjob_system.h"

namespace castray::tb {

class JobSystem : public testing::TestWithParam<Stalls> {
 protected:
  using D = Dut<Vjob_system>;
  JobSystem() {
    image_.job.height = image_.job.y1 = image_.frame.height = 24;
    image_.job.image_bytes = image_.header.image_bytes = 256 * 40;
    image_.job.frame_bytes = 192 * 24;
    image_.job.want_hits = 0;
  }

  void make(Stalls stalls = {}, int latency_max = 20) {
    SubConfig config;
    config.stall = stalls.sink;
    config.burst = stalls.burst;
    config.latency_max = latency_max;
    config.max_outstanding = 6;
    reads_ = std::make_unique<ReadSub>(config, 3, [this](std::uint64_t addr) { return fetch(addr); });
    writes_ = std::make_unique<WriteSub>(config, 4);
    bus_.idle();
    dut_.reset();
  }

  // The image: header and record; behind it, and in the datapath's reads, each beat its number.
  Beat fetch(std::uint64_t addr) {
    const std::uint64_t offset = addr - image_.job.image;
    EXPECT_LT(offset, image_.job.image_bytes) << "a read outside the image";
    Beat beat{static_cast<std::uint32_t>(offset / 16), 0, 0, 0};
    if (loading_) std::memcpy(beat.data(), image_.bytes().data() + offset % 256, 16);
    return beat;
  }

  void tick() {
    reads_->drive(dut_);
    writes_->drive(dut_);
    dut_.settle();
    if (dut_->m_axi_arvalid_o && dut_->m_axi_arready_i) loading_ = dut_->m_axi_arid_o == 0;
    reads_->observe(dut_);
    writes_->observe(dut_);
    EXPECT_FALSE(dut_->lost_o) << "a beat that nobody waits for, or a wrong one";
    dut_.tick();
    ++now_;
  }

  void start() {
    const job_t& job = image_.job;
    bus_.write(RegImage, static_cast<std::uint32_t>(job.image));
    bus_.write(RegImage + 4, static_cast<std::uint32_t>(job.image >> 32));
    bus_.write(RegFrame, static_cast<std::uint32_t>(job.frame));
    bus_.write(RegFrame + 4, static_cast<std::uint32_t>(job.frame >> 32));
    bus_.write(RegImageBytes, static_cast<std::uint32_t>(job.image_bytes));
    bus_.write(RegFrameBytes, static_cast<std::uint32_t>(job.frame_bytes));
    bus_.write(RegFrameSize, static_cast<std::uint32_t>(job.width | job.height << 16));
    bus_.write(RegHits, static_cast<std::uint32_t>(job.hits));
    bus_.write(RegHits + 4, static_cast<std::uint32_t>(job.hits >> 32));
    bus_.write(RegHitsBytes, static_cast<std::uint32_t>(job.hits_bytes));
    bus_.write(RegRays, static_cast<std::uint32_t>(job.rays));
    bus_.write(RegRays + 4, static_cast<std::uint32_t>(job.rays >> 32));
    bus_.write(RegRayBytes, static_cast<std::uint32_t>(job.ray_bytes));
    bus_.write(RegRayCount, static_cast<std::uint32_t>(job.ray_count));
    bus_.write(RegOptions, job.is_list ? 1u << OptionList : 0);
    bus_.write(RegGie, 1);
    bus_.write(RegIer, 1);
    loading_ = true;
    started_at_ = now_;
    bus_.write(RegControl, 1u << CtrlStart);
  }
  // Until the interrupt; the error code.
  int finish() {
    for (int i = 0; i < 20000 && !dut_->interrupt_o; ++i) tick();
    EXPECT_TRUE(dut_->interrupt_o) << "the job hangs";
    finished_at_ = now_;
    EXPECT_EQ(reads_->outstanding, 0u);
    EXPECT_EQ(writes_->outstanding, 0u);
    EXPECT_EQ(bus_.read(RegControl), 1u << CtrlDone | 1u << CtrlReady | 1u << CtrlIdle | 1u << CtrlInterrupt);
    bus_.write(RegIsr, 1);
    EXPECT_FALSE(dut_->interrupt_o);
    return static_cast<int>(bus_.read(RegError));
  }
  std::uint64_t counter(int index) {
    return bus_.read(RegCounters + 8 * index) | std::uint64_t{bus_.read(RegCounters + 8 * index + 4)} << 32;
  }
  void expect_good_job() {
    start();
    EXPECT_EQ(finish(), ErrNone);
    EXPECT_EQ(counter(CntReadBeats), 16 + 16 * image_.job.height);
    EXPECT_EQ(counter(CntWriteBeats), 4 * image_.job.height);
    for (unsigned i = 0; i < 4 * image_.job.height; ++i)
      EXPECT_EQ(writes_->load(image_.job.frame + 16 * i), (Beat{i / 4, i / 4, i / 4, i / 4}));
  }
  void stop_errors() {
    reads_->config().error_from = reads_->config().error_to = 0;
    writes_->config().error_from = writes_->config().error_to = 0;
  }

  TestImage image_;
  D dut_;
  std::unique_ptr<ReadSub> reads_;
  std::unique_ptr<WriteSub> writes_;
  LiteBus<D> bus_{dut_, [this] { tick(); }};
  bool loading_ = true;
  long now_ = 0, started_at_ = 0, finished_at_ = 0;
};

TEST_P(JobSystem, RunsJobAfterJob) {
  make(GetParam());
  for (int i = 0; i < 5; ++i) expect_good_job();
}

TEST_P(JobSystem, EndsOnEveryReadErrorAndGoesOn) {
  make(GetParam());
  for (unsigned beat = 0; beat < 16 * 24; beat += 29) {
    reads_->config().error_from = image_.job.image + 16 * beat;
    reads_->config().error_to = reads_->config().error_from + 16;
    start();
    EXPECT_EQ(finish(), ErrReadBus) << beat;
    stop_errors();
    expect_good_job();
  }
}

TEST_P(JobSystem, EndsOnEveryWriteErrorAndGoesOn) {
  make(GetParam());
  for (unsigned burst = 0; burst < 24; ++burst) {
    writes_->config().error_from = image_.job.frame + 64 * burst;
    writes_->config().error_to = writes_->config().error_from + 64;
    start();
    EXPECT_EQ(finish(), ErrWriteBus) << burst;
    stop_errors();
    expect_good_job();
  }
}

TEST_P(JobSystem, WorksAfterAResetAtAnyMoment) {
  make(GetParam());
  std::mt19937 rng(5);
  for (int round = 0; round < 60; ++round) {
    start();
    const int cut = static_cast<int>(rng() % (round % 2 ? 80 : 900));
    for (int i = 0; i < cut; ++i) tick();
    bus_.idle();
    dut_->m_axi_rvalid_i = dut_->m_axi_bvalid_i = 0;
    dut_.reset(1);
    reads_->reset();
    writes_->reset();
    EXPECT_EQ(bus_.read(RegControl), 1u << CtrlIdle);
    expect_good_job();
  }
}
INSTANTIATE_TEST_SUITE_P(Stalls, JobSystem, testing::ValuesIn(kStallPatterns),
                         [](const auto& info) { return info.param.name; });

TEST_F(JobSystem, ReportsEveryCodeOfTheChecks) {
  make();
  for (const auto& [list, count] : {std::pair{kRecordDefects, std::size(kRecordDefects)}, std::pair{kJobDefects, std::size(kJobDefects)}}) {
    for (std::size_t i = 0; i < count; ++i) {
      const TestImage good = image_;
      SCOPED_TRACE(list[i].name);
      list[i].spoil(image_);
      // Hits are asked for of lists only, and the window is the frame.
      job_t job = image_.job;
      job.illegal = job.x0 = job.y0 = 0;
      job.want_hits = job.is_list;
      job.x1 = job.width;
      job.y1 = job.height;
      const error_t expected = check_image(image_.bytes().data(), HeaderBytes + FrameBytes, job);
      if (expected != ErrNone) {
        start();
        EXPECT_EQ(finish(), expected) << list[i].name;
      }
      image_ = good;
      expect_good_job();
    }
  }
}

TEST_F(JobSystem, CountsTheCyclesFromStartToDone) {
  make();
  expect_good_job();
  EXPECT_NEAR(static_cast<double>(counter(CntCycles)), static_cast<double>(finished_at_ - started_at_), 8);
  const std::uint64_t cycles = counter(CntCycles);
  for (int i = 0; i < 50; ++i) tick();
  EXPECT_EQ(counter(CntCycles), cycles) << "held after done";
}

// Until the memory answers there is no end, however long it takes.
TEST_F(JobSystem, WaitsForASilentMemory) {
  make();
  start();
  for (int i = 0; i < 300; ++i) tick();
  reads_->silent = writes_->silent = true;
  for (int i = 0; i < 3000; ++i) tick();
  EXPECT_FALSE(dut_->interrupt_o);
  EXPECT_EQ(bus_.read(RegControl), 1u << CtrlStart);
  reads_->silent = writes_->silent = false;
  EXPECT_EQ(finish(), ErrNone);
}

}  // namespace castray::tb
