// SPDX-License-Identifier: Apache-2.0
// The core on a board, through its registers and a piece of memory that both reach. A job starts only where all of its
// windows lie in buffers of this device; whatever goes wrong, the core is left idle, or the error says that it is not.
#pragma once
#include <chrono>
#include <map>
#include <memory>

#include "device.hpp"
#include "uio/free_space.hpp"
#include "uio/registers.hpp"
#include "uio/shared_memory.hpp"

namespace castray::sim {

struct BoardPatience {
  std::chrono::milliseconds silence{10'000};  // without any progress of the core: it hangs
  bool poll = false;                          // never wait for the interrupt
};

class BoardDevice final : public Device {
 public:
  // Throws DeviceError unless the core is of this build and idle, or becomes so.
  BoardDevice(std::unique_ptr<Registers> registers, std::unique_ptr<SharedMemory> memory, const BoardPatience& patience = {});
  ~BoardDevice() override;

  std::string description() const override;
  Buffer allocate(std::uint64_t bytes) override;
  void release(const Buffer& buffer) override { space_.give(buffer.address - memory_->address()); }
  void write(std::uint64_t address, std::span<const std::uint8_t> bytes) override;
  void read(std::uint64_t address, std::span<std::uint8_t> bytes) override;
  void write_reg(unsigned offset, std::uint32_t value) override;
  std::uint32_t read_reg(unsigned offset) override { return registers_->read(offset); }
  Wait wait_interrupt(const Progress& progress) override;
  // A core on a board has no reset of its own: waits until it is idle and clears its arguments.
  void reset() override;

 private:
  std::uint64_t counter(std::int64_t index) const;
  std::uint64_t work() const;
  void check_core() const;
  void check_windows();
  std::uint64_t offset_of(std::uint64_t address, std::uint64_t bytes) const;
  Irq wait_a_while();
  // Turns interrupts off and waits for the end of what runs; false if nothing moves any more before it.
  bool make_idle();

  std::unique_ptr<Registers> registers_;
  std::unique_ptr<SharedMemory> memory_;
  std::chrono::milliseconds silence_;
  bool polling_;
  bool interrupt_lost_ = false;  // a job ended, and its interrupt did not come
  bool stuck_ = false;           // a job did not end: its memory may still be written
  FreeSpace space_;
  std::map<unsigned, std::uint32_t> written_;  // the argument registers
};

}  // namespace castray::sim
