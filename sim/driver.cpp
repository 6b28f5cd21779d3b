// SPDX-License-Identifier: Apache-2.0
#include "driver.hpp"

#include <cstring>

#include "build_check.hpp"
#include "mem/image.hpp"

namespace castray::sim {
namespace {

constexpr std::uint8_t kUntouched = 0xa5;  // what the buffers hold before the core writes them

std::uint32_t pair(int low, int high) { return static_cast<std::uint32_t>(low) | static_cast<std::uint32_t>(high) << 16; }

}  // namespace

hit_record_t Rendering::hit(std::size_t pixel) const { return load_record<hit_record_t>(&hits[pixel * HitBytes]); }
hit_record_t Answers::hit(std::size_t ray) const { return load_record<hit_record_t>(&hits[ray * HitBytes]); }

std::vector<std::uint8_t> bytes_of(std::span<const ray_record_t> rays) {
  std::vector<std::uint8_t> bytes(rays.size() * RayBytes);
  for (std::size_t i = 0; i < rays.size(); ++i) store_record(&bytes[i * RayBytes], rays[i]);
  return bytes;
}

Driver::Driver(Device& device) : device_(device) {
  check_build([&](unsigned offset) { return device_.read_reg(offset); });
}

Driver::~Driver() { release(); }

void Driver::release() {
  for (Buffer* buffer : {&image_, &frame_, &hits_, &rays_, &answers_}) {
    if (buffer->bytes) device_.release(*buffer);
    *buffer = {};
  }
}

void Driver::load(const SceneImage& image) {
  release();
  record_ = image.frame;
  image_ = device_.allocate(image.bytes.size());
  frame_ = device_.allocate(record_.stride * record_.height);
  hits_ = device_.allocate(record_.width * record_.height * HitBytes);
  device_.write(image_.address, image.bytes);
}

void Driver::set_pointer(std::int64_t reg, std::uint64_t address) {
  set(reg, static_cast<std::uint32_t>(address));
  set(reg + 4, static_cast<std::uint32_t>(address >> 32));
}

void Driver::set_image(std::uint32_t steps) {
  set_pointer(RegImage, image_.address);
  set(RegImageBytes, static_cast<std::uint32_t>(image_.bytes));
  set(RegSteps, steps);
}

void Driver::set_arguments(const RenderOptions& options) {
  want_hits_ = options.hits;
  set_image(options.steps);
  set_pointer(RegFrame, frame_.address);
  set_pointer(RegHits, options.hits ? hits_.address : 0);
  set(RegFrameBytes, static_cast<std::uint32_t>(frame_.bytes));
  set(RegHitsBytes, options.hits ? static_cast<std::uint32_t>(hits_.bytes) : 0);
  set(RegFrameSize, pair(static_cast<int>(record_.width), static_cast<int>(record_.height)));
  set(RegOptions, (options.hits ? 1u << OptionHits : 0) | (options.work ? 1u << OptionWork : 0) | (options.z_order ? 1u << OptionZOrder : 0) |
                      (options.mode == Mode::kBrute ? 1u << OptionBrute : 0) | (options.mode == Mode::kBvhRoot ? 1u << OptionRoot : 0));
  const PixelWindow window = options.window.value_or(PixelWindow{});
  set(RegWindowMin, pair(window.x0, window.y0));
  set(RegWindowMax, pair(window.x1, window.y1));
}

void Driver::set_list_arguments(const QueryOptions& options) {
  set_image(options.steps);
  set_pointer(RegRays, rays_.address);
  set(RegRayBytes, static_cast<std::uint32_t>(rays_.bytes));
  set(RegRayCount, static_cast<std::uint32_t>(rays_.bytes / RayBytes));
  set_pointer(RegHits, answers_.address);
  set(RegHitsBytes, static_cast<std::uint32_t>(answers_.bytes));
  set(RegOptions, 1u << OptionList | (options.work ? 1u << OptionWork : 0) | (options.mode == Mode::kBrute ? 1u << OptionBrute : 0));
}

void Driver::go() {
  set(RegIer, 1u << IsrDone);
  set(RegGie, 1);
  set(RegControl, 1u << CtrlStart);
}

void Driver::prepare(const RenderOptions& options) {
  device_.write(frame_.address, std::vector<std::uint8_t>(frame_.bytes, kUntouched));
  if (options.hits) device_.write(hits_.address, std::vector<std::uint8_t>(hits_.bytes, kUntouched));
  set_arguments(options);
}

void Driver::start(const RenderOptions& options) {
  prepare(options);
  go();
}

void Driver::load_rays(std::span<const std::uint8_t> rays) {
  if (rays.empty() || rays.size() % RayBytes != 0 || rays.size() / RayBytes > MaxRays)
    throw std::invalid_argument("a list of rays has 1 to " + std::to_string(MaxRays) + " records of " + std::to_string(RayBytes) + " bytes");
  for (Buffer* buffer : {&rays_, &answers_})
    if (buffer->bytes) device_.release(*buffer);
  rays_ = device_.allocate(rays.size());
  answers_ = device_.allocate(rays.size() / RayBytes * HitBytes);
  device_.write(rays_.address, rays);
  device_.write(answers_.address, std::vector<std::uint8_t>(answers_.bytes, kUntouched));
}

void Driver::start(std::span<const std::uint8_t> rays, const QueryOptions& options) {
  load_rays(rays);
  set_list_arguments(options);
  go();
}

std::uint64_t Driver::counter(std::int64_t index) {
  const auto offset = static_cast<unsigned>(RegCounters + 8 * index);
  return device_.read_reg(offset) | std::uint64_t{device_.read_reg(offset + 4)} << 32;
}

error_t Driver::end_job(Counts& counters) {
  set(RegIsr, device_.read_reg(RegIsr));
  const std::uint32_t control = device_.read_reg(RegControl);
  if (!(control >> CtrlDone & 1)) throw DeviceError("the interrupt came, but the job is not done: control register " + hex(control));
  for (std::int64_t i = 0; i < Counters; ++i) counters[static_cast<std::size_t>(i)] = counter(i);
  return static_cast<error_t>(device_.read_reg(RegError));
}

Rendering Driver::finish() {
  Rendering result;
  result.error = end_job(result.counters);
  result.width = static_cast<int>(record_.width);
  result.height = static_cast<int>(record_.height);

  const std::size_t row = record_.width * PixelBytes;
  std::vector<std::uint8_t> bytes(frame_.bytes);
  device_.read(frame_.address, bytes);
  result.pixels.resize(record_.width * record_.height);
  for (std::size_t y = 0; y < record_.height; ++y)
    std::memcpy(&result.pixels[y * record_.width], &bytes[y * record_.stride], row);
  if (want_hits_) {
    result.hits.resize(hits_.bytes);
    device_.read(hits_.address, result.hits);
  }
  return result;
}

Answers Driver::finish_query() {
  Answers result;
  result.error = end_job(result.counters);
  result.hits.resize(answers_.bytes);
  device_.read(answers_.address, result.hits);
  return result;
}

void Driver::wait(const Progress& progress) {
  if (device_.wait_interrupt(progress) == Wait::kHung) throw DeviceError("the core hangs: no interrupt, and no traffic on its bus");
}

Rendering Driver::render(const RenderOptions& options, const Progress& progress) {
  start(options);
  wait(progress);
  return finish();
}

Answers Driver::query(std::span<const std::uint8_t> rays, const QueryOptions& options, const Progress& progress) {
  start(rays, options);
  wait(progress);
  return finish_query();
}

}  // namespace castray::sim
