// SPDX-License-Identifier: Apache-2.0
#include "uio/board_device.hpp"

#include <algorithm>
#include <vector>

#include "axi/axi_lite_regs.hpp"
#include "axi_ports.hpp"
#include "build_check.hpp"
#include "job_windows.hpp"

namespace castray::sim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kSlice{100};  // between two looks at progress
constexpr std::uint64_t kChunk = 1 << 20;         // zeros at a time
constexpr std::uint32_t bit(std::int64_t number) { return std::uint32_t{1} << number; }
constexpr const char* kReload = "load the bitstream anew before the next job";

// The configuration register, field by field.
struct Config {
  std::uint32_t lanes, contexts, tile;
  explicit Config(std::uint32_t word) : lanes(word & 0xff), contexts(word >> 8 & 0xff), tile(word >> 16 & 0xff) {}
  bool of_a_core() const {
    return lanes >= 1 && lanes <= std::uint32_t{MaxLanes} && contexts >= 1 && contexts <= bit(CtxW) &&
           (tile == 4 || tile == 8 || tile == 16);
  }
};

// How long nothing moved: work() is what a job has done.
class Stillness {
 public:
  explicit Stillness(std::uint64_t work) : last_(work) {}
  Clock::duration at(std::uint64_t work) {
    const Clock::time_point now = Clock::now();
    if (work != last_) moved_ = now;
    last_ = work;
    return now - moved_;
  }

 private:
  std::uint64_t last_;
  Clock::time_point moved_ = Clock::now();
};

}  // namespace

BoardDevice::BoardDevice(std::unique_ptr<Registers> registers, std::unique_ptr<SharedMemory> memory,
                         const BoardPatience& patience)
    : registers_(std::move(registers)),
      memory_(std::move(memory)),
      silence_(patience.silence),
      polling_(patience.poll),
      space_(memory_->bytes()) {
  check_core();
  const std::uint64_t end = memory_->address() + memory_->bytes();
  if (memory_->address() % FreeSpace::kPage != 0 || end < memory_->address() || end > std::uint64_t{1} << AddrW)
    throw DeviceError(memory_->name() + ": the core does not reach it: it must begin at a multiple of " +
                      std::to_string(FreeSpace::kPage) + " and end below 2^" + std::to_string(AddrW));
  if (!make_idle()) throw DeviceError(registers_->name() + ": the core is busy with a job that does not end: " + kReload);
}

BoardDevice::~BoardDevice() {
  try {
    if (!stuck_) make_idle();
  } catch (const std::exception&) {
    // What could not be reached cannot be left in order.
  }
}

void BoardDevice::check_core() const {
  try {
    check_build([&](unsigned offset) { return registers_->read(offset); });
  } catch (const DeviceError& error) {
    throw DeviceError(registers_->name() + ": " + error.what() +
                      ": load the bitstream that was built from the same sources as this program");
  }
  const std::uint32_t word = registers_->read(RegConfig);
  if (!Config(word).of_a_core())
    throw DeviceError(registers_->name() + ": the configuration register holds " + hex(word) +
                      ", which no core has: load the bitstream anew");
}

std::string BoardDevice::description() const {
  const Config config(registers_->read(RegConfig));
  const char* const ends = interrupt_lost_ ? "polled, as no interrupt came" : polling_ ? "polled" : "interrupt";
  return registers_->name() + ": lanes " + std::to_string(config.lanes) + ", contexts " + std::to_string(config.contexts) +
         ", tiles of " + std::to_string(config.tile) + "x" + std::to_string(config.tile) + "; memory " + memory_->name() +
         " of " + std::to_string(memory_->bytes()) + " bytes; " + ends;
}

// ---- Memory ----
Buffer BoardDevice::allocate(std::uint64_t bytes) {
  if (stuck_) throw DeviceError(registers_->name() + ": the last job did not end: " + kReload);
  const auto offset = space_.take(bytes);
  if (!offset)
    throw DeviceError(memory_->name() + ": the job needs " + std::to_string(bytes) + " bytes more in one piece, " +
                      std::to_string(space_.left()) + " of its " + std::to_string(memory_->bytes()) +
                      " are free: make the buffer larger, as docs/uio.md says, or the frame smaller");
  const Buffer buffer{memory_->address() + *offset, bytes};
  const std::vector<std::uint8_t> zeros(std::min(bytes, kChunk));
  for (std::uint64_t done = 0; done < bytes; done += zeros.size())
    memory_->write(*offset + done, std::span(zeros).first(std::min<std::uint64_t>(zeros.size(), bytes - done)));
  return buffer;
}

std::uint64_t BoardDevice::offset_of(std::uint64_t address, std::uint64_t bytes) const {
  const std::uint64_t offset = address - memory_->address();
  if (address < memory_->address() || !space_.holds(offset, bytes))
    throw DeviceError("the host touches device memory that was never allocated");
  return offset;
}

void BoardDevice::write(std::uint64_t address, std::span<const std::uint8_t> bytes) {
  memory_->write(offset_of(address, bytes.size()), bytes);
}
void BoardDevice::read(std::uint64_t address, std::span<std::uint8_t> bytes) {
  memory_->read(offset_of(address, bytes.size()), bytes);
}

// ---- Registers ----
void BoardDevice::write_reg(unsigned offset, std::uint32_t value) {
  if (offset == RegControl && (value & bit(CtrlStart))) check_windows();
  written_[offset] = value;
  registers_->write(offset, value);
}

void BoardDevice::check_windows() {
  const job_t job = job_of_registers([&](unsigned offset) {
    const auto found = written_.find(offset);
    return found == written_.end() ? 0 : found->second;
  });
  for (const JobWindow& window : windows_of(job)) {
    if (window.address >= memory_->address() && space_.holds(window.address - memory_->address(), window.bytes)) continue;
    make_idle();
    throw DeviceError("nothing was started: the job's " + std::string(window.name) + " does not lie in a buffer of " +
                      memory_->name());
  }
}

std::uint64_t BoardDevice::counter(std::int64_t index) const {
  const auto offset = static_cast<unsigned>(RegCounters + 8 * index);
  return registers_->read(offset) | std::uint64_t{registers_->read(offset + 4)} << 32;
}

// Grows as long as a job gets on.
std::uint64_t BoardDevice::work() const {
  return counter(CntReadBeats) + counter(CntWriteBeats) + counter(CntTests) + counter(CntNodes);
}

// ---- Jobs ----
Irq BoardDevice::wait_a_while() {
  const Irq irq = polling_ ? Irq::kNone : registers_->wait(kSlice);
  if (irq == Irq::kNone) {
    polling_ = true;
    registers_->pause();
  }
  return irq;
}

Wait BoardDevice::wait_interrupt(const Progress& progress) {
  const std::uint64_t expected = bytes_written(job_of_registers([&](unsigned offset) { return written_[offset]; }));
  Clock::time_point looked = Clock::now();
  Stillness still(work());
  for (;;) {
    const Irq irq = wait_a_while();
    // The interrupt's own register tells, not the line: one that was lost, or is not connected, is no hang.
    if (registers_->read(RegIsr) & bit(IsrDone)) {
      if (irq == Irq::kSilent) polling_ = interrupt_lost_ = true;
      return Wait::kInterrupt;
    }
    if (Clock::now() - looked < kSlice && irq != Irq::kSilent) continue;
    looked = Clock::now();
    if (progress) {
      const double written = static_cast<double>(counter(CntWriteBeats)) * kBeatBytes;
      progress(std::min(1.0, written / static_cast<double>(std::max<std::uint64_t>(expected, 1))), counter(CntCycles));
    }
    if (still.at(work()) > silence_) break;
  }
  const std::string what =
      registers_->name() + ": the job does not end, and nothing moved for " + std::to_string(silence_.count()) + " ms; ";
  throw DeviceError(what + (make_idle() ? "the core is idle again" : std::string("the core is still busy: ") + kReload));
}

bool BoardDevice::make_idle() {
  registers_->write(RegGie, 0);
  registers_->write(RegIer, 0);
  registers_->write(RegControl, 0);  // no auto restart
  Stillness still(work());
  while (!(registers_->read(RegControl) & bit(CtrlIdle))) {
    registers_->pause();
    stuck_ = still.at(work()) > silence_;
    if (stuck_) return false;
  }
  // Ones toggle: what is set is cleared.
  if (const std::uint32_t raised = registers_->read(RegIsr)) registers_->write(RegIsr, raised);
  return true;
}

void BoardDevice::reset() {
  if (!make_idle()) throw DeviceError(registers_->name() + ": the core does not become idle: " + kReload);
  for (const auto& [offset, value] : written_)
    if (offset >= RegImage) registers_->write(offset, 0);
  written_.clear();
}

}  // namespace castray::sim
