// SPDX-License-Identifier: Apache-2.0
// A board whose core is the Verilated one: its registers in place of the mapped ones, and the kernel's buffer, a plain
// file, as its memory.
#pragma once
#include <fcntl.h>

#include <map>
#include <memory>

#include "kernel_files.hpp"
#include "rtl_device.hpp"
#include "uio/udmabuf.hpp"

namespace castray::tb {

// The core, and what is wrong with the board around it.
struct SimulatedCore {
  explicit SimulatedCore(const KernelFiles& kernel)
      : file(kernel.roots.dev / "udmabuf0", O_RDWR), bytes(std::filesystem::file_size(kernel.roots.dev / "udmabuf0")),
        memory(file, "udmabuf0", 0, bytes), rtl(options()) {
    rtl.attach(KernelFiles::kAddress, {memory.data(), bytes});
  }
  static sim::RtlOptions options() {
    sim::RtlOptions options;
    options.variant = {1, DefaultContexts, DefaultTileLog2, 1, 0};
    return options;
  }

  sim::OpenFile file;
  std::uint64_t bytes;
  sim::Mapping memory;
  sim::RtlDevice rtl;
  sim::Irq without = sim::Irq::kRaised;  // kSilent: interrupts are lost; kNone: there is no line
  bool deaf = false;                     // starts are not heard
  std::map<unsigned, std::uint32_t> lies;
  std::map<unsigned, std::uint32_t> written;
  unsigned starts = 0;
  unsigned waits = 0;
};

class SimulatedRegisters final : public sim::Registers {
 public:
  explicit SimulatedRegisters(std::shared_ptr<SimulatedCore> core) : core_(std::move(core)) {}

  std::string name() const override { return "simulated core"; }
  std::uint32_t read(unsigned offset) override {
    const auto lie = core_->lies.find(offset);
    return lie == core_->lies.end() ? core_->rtl.read_reg(offset) : lie->second;
  }
  void write(unsigned offset, std::uint32_t value) override {
    core_->written[offset] = value;
    const bool start = offset == RegControl && (value >> CtrlStart & 1);
    core_->starts += start;
    if (!(start && core_->deaf)) core_->rtl.write_reg(offset, value);
  }
  sim::Irq wait(std::chrono::milliseconds) override {
    ++core_->waits;
    if (core_->without == sim::Irq::kNone) return sim::Irq::kNone;
    const bool raised = core_->rtl.advance(kWaitCycles);
    return raised && core_->without == sim::Irq::kRaised ? sim::Irq::kRaised : sim::Irq::kSilent;
  }
  void pause() override { core_->rtl.advance(kPauseCycles); }

 private:
  static constexpr std::uint64_t kWaitCycles = 50'000, kPauseCycles = 2'000;

  std::shared_ptr<SimulatedCore> core_;
};

inline std::unique_ptr<sim::Device> open_simulated(const std::shared_ptr<SimulatedCore>& core, const sim::BoardOptions& options) {
  return std::make_unique<sim::BoardDevice>(std::make_unique<SimulatedRegisters>(core), sim::open_memory(options),
                                            options.patience);
}

// What a call that must throw DeviceError says: one line.
template <class Call> std::string refusal(Call&& call) {
  try {
    call();
  } catch (const sim::DeviceError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what;
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}
inline testing::AssertionResult says(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if (text.find(word) == std::string::npos) return testing::AssertionFailure() << "'" << word << "' is not in: " << text;
  return testing::AssertionSuccess();
}

}  // namespace castray::tb
