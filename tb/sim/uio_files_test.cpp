// SPDX-License-Identifier: Apache-2.0
// How the parts of the device layer use the kernel's files: here plain ones, and a pair of sockets for the interrupt.
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <numeric>

#include "simulated_board.hpp"
#include "uio/reserved_memory.hpp"
#include "uio/uio_registers.hpp"

namespace castray::tb {
namespace {

using std::chrono::milliseconds;

std::vector<std::uint8_t> counting(std::size_t bytes) {
  std::vector<std::uint8_t> list(bytes);
  std::iota(list.begin(), list.end(), std::uint8_t{1});
  return list;
}

class UioFiles : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    kernel_.emplace(folder_);
  }
  std::string find(const std::string& name) const { return sim::find_uio(kernel_->roots, name).file.filename().string(); }
  std::string refused(const std::string& name) const {
    return refusal([&] { sim::find_uio(kernel_->roots, name); });
  }

  std::optional<KernelFiles> kernel_;
};

TEST_F(UioFiles, TheCoreIsFoundByItsName) {
  kernel_->add_uio("uio1", "axi-pmon");
  kernel_->add_uio("uio2", "castray_two");
  EXPECT_EQ(find("castray@"), "uio0");
  EXPECT_EQ(find("castray_two"), "uio2");
  EXPECT_EQ(find((kernel_->roots.dev / "uio2").string()), "uio2");
  EXPECT_TRUE(says(refused("castray"), {"several", "uio0", "uio2", "--uio"}));
  EXPECT_TRUE(says(refused("castle"), {"no board", "castle", "axi-pmon", "bitstream"}));
  EXPECT_TRUE(says(refused("/dev/uio7"), {"no board", "/dev/uio7"}));
}

TEST_F(UioFiles, WithoutABoardItSaysSo) {
  EXPECT_TRUE(says(
      refusal([] {
        sim::open_board({.uio = "castray", .udmabuf = "", .reserved = "", .patience = {}, .roots = {"/nowhere", "/nowhere"}});
      }),
      {"no board", "/nowhere/class/uio", "--engine rtl"}));
  const auto state = kernel_->roots.sys / "class/fpga_manager/fpga0/state";
  std::filesystem::create_directories(state.parent_path());
  KernelFiles::put(state, "unknown\n");
  EXPECT_TRUE(says(refused("castray"), {"no bitstream", "unknown"}));
  KernelFiles::put(state, "operating\n");
  EXPECT_EQ(find("castray"), "uio0");
}

TEST_F(UioFiles, ADeviceThatMapsTooLittleIsAnother) {
  kernel_->add_uio("uio0", "castray", "0x80");
  EXPECT_TRUE(says(refused("castray"), {"uio0", "128 bytes", "not this core"}));
  kernel_->add_uio("uio0", "castray", "lots");
  EXPECT_TRUE(says(refused("castray"), {"map0/size", "lots", "not a number"}));
}

TEST_F(UioFiles, RegistersAreTheMappedWords) {
  KernelFiles::put(kernel_->uio() / "uio0/maps/map0/offset", "0x40\n");
  const auto file = kernel_->roots.dev / "uio0";
  sim::UioRegisters registers(sim::find_uio(kernel_->roots, "castray"));
  registers.write(RegImage, 0x89abcdef);
  EXPECT_EQ(registers.read(RegImage), 0x89abcdefu);
  EXPECT_EQ(KernelFiles::text(file).substr(0x40 + RegImage, 4), "\xef\xcd\xab\x89");
  EXPECT_TRUE(says(registers.name(), {"uio0", "castray@a0000000"}));
  EXPECT_TRUE(says(refusal([&] { sim::UioRegisters(sim::find_uio(kernel_->roots, "castray")); }), {"uio0", "another program"}));
}

TEST_F(UioFiles, AMissingNodeIsNamed) {
  std::filesystem::remove(kernel_->roots.dev / "uio0");
  EXPECT_TRUE(says(refusal([&] { sim::open_board(kernel_->options()); }), {"dev/uio0", "cannot be opened"}));
}

// ---- The interrupt ----
struct Sockets {
  Sockets() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0); }
  ~Sockets() {
    close(ends[0]);
    close(ends[1]);
  }
  int ends[2] = {};
};

TEST(InterruptLine, IsLetThroughAndTaken) {
  const Sockets kernel;
  sim::InterruptLine line(kernel.ends[0]);
  EXPECT_EQ(line.wait(milliseconds(1)), sim::Irq::kSilent);
  std::uint32_t word = 7;
  ASSERT_EQ(read(kernel.ends[1], &word, sizeof word), 4);
  EXPECT_EQ(word, 1u) << "the interrupt was not let through";
  ASSERT_EQ(write(kernel.ends[1], &word, sizeof word), 4);
  EXPECT_EQ(line.wait(milliseconds(1000)), sim::Irq::kRaised);
  EXPECT_EQ(line.wait(milliseconds(1)), sim::Irq::kSilent) << "it was taken before";
}

TEST(InterruptLine, WhereThereIsNoneItIsNotAskedForAgain) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  sim::InterruptLine line(pipe_ends[0]);  // refuses what is written, as a device without an interrupt does
  EXPECT_EQ(line.wait(milliseconds(1)), sim::Irq::kNone);
  EXPECT_EQ(line.wait(milliseconds(1)), sim::Irq::kNone);
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

// ---- Memory ----
// A processor with a cache: what the core sees is in memory only once it was handed over, and the other way round.
class CachedBuffer final : public sim::Udmabuf {
 public:
  using Udmabuf::Udmabuf;
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(KernelFiles::kBytes);

 protected:
  void hand_to(Owner owner, std::uint64_t offset, std::uint64_t bytes) override {
    std::uint8_t* const cache = data() + offset;
    if (owner == Owner::kDevice) std::copy_n(cache, bytes, memory.begin() + static_cast<std::ptrdiff_t>(offset));
    else std::copy_n(memory.begin() + static_cast<std::ptrdiff_t>(offset), bytes, cache);
  }
};

TEST_F(UioFiles, CachesAreCleanedBehindWritesAndBeforeReads) {
  CachedBuffer buffer(kernel_->roots, "");
  const std::vector<std::uint8_t> bytes = counting(100);
  buffer.write(4096, bytes);
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), buffer.memory.begin() + 4096));
  buffer.memory[4100] = 77;
  std::vector<std::uint8_t> back(100);
  buffer.read(4096, back);
  EXPECT_EQ(back[4], 77);
  EXPECT_EQ(back[99], 100);
}

TEST_F(UioFiles, TheModuleIsToldWhichBytes) {
  sim::Udmabuf buffer(kernel_->roots, "udmabuf0");
  EXPECT_EQ(buffer.address(), KernelFiles::kAddress);
  EXPECT_EQ(buffer.bytes(), KernelFiles::kBytes);
  const auto told = [&](const char* name) { return KernelFiles::text(kernel_->buffer() / name); };
  buffer.write(0x10000, counting(300));
  EXPECT_EQ(told("sync_offset"), "65536");
  EXPECT_EQ(told("sync_size"), "300");
  EXPECT_EQ(told("sync_direction"), "1");
  EXPECT_EQ(told("sync_for_device"), "1");
  EXPECT_EQ(told("sync_for_cpu"), "0\n");
  std::vector<std::uint8_t> back(5);
  buffer.read(0x10002, back);
  EXPECT_EQ(back[0], 3);
  EXPECT_EQ(told("sync_offset"), "65538");
  EXPECT_EQ(told("sync_size"), "5");
  EXPECT_EQ(told("sync_direction"), "2");
  EXPECT_EQ(told("sync_for_cpu"), "1");
}

TEST_F(UioFiles, WithoutABufferItSaysSo) {
  EXPECT_TRUE(says(refusal([&] { sim::Udmabuf(kernel_->roots, "udmabuf1"); }), {"udmabuf1", "u-dma-buf"}));
  std::filesystem::remove_all(kernel_->buffer());
  EXPECT_TRUE(says(refusal([&] { sim::Udmabuf(kernel_->roots, ""); }), {"no buffer", "u-dma-buf"}));
}

TEST_F(UioFiles, ReservedMemoryIsMappedAtItsAddress) {
  const auto mem = kernel_->roots.dev / "mem";
  KernelFiles::put(mem, std::string(5 * 4096, 'x'));
  sim::BoardOptions options = kernel_->options();
  options.reserved = "0x2000:8192";
  const auto memory = sim::open_memory(options);
  EXPECT_EQ(memory->address(), 0x2000u);
  EXPECT_EQ(memory->bytes(), 8192u);
  const std::vector<std::uint8_t> bytes = counting(29);
  memory->write(3, bytes);  // neither begins nor ends on a word
  const std::string text = KernelFiles::text(mem);
  EXPECT_EQ(text.substr(0x2002, 31), "x" + std::string(bytes.begin(), bytes.end()) + "x");
  std::vector<std::uint8_t> back(29);
  memory->read(3, back);
  EXPECT_EQ(back, bytes);
}

TEST_F(UioFiles, ARegionHasOneForm) {
  sim::BoardOptions options = kernel_->options();
  for (const char* text : {"0x2000", "0x2000:", ":4096", "0x2000:100", "0x2001:4096", "0x2000:0", "-4096:4096", "0x2000:4096x",
                           "99999999999999999999:4096"}) {
    options.reserved = text;
    EXPECT_TRUE(says(refusal([&] { sim::open_memory(options); }), {"--reserved", text, "ADDRESS:BYTES"}));
  }
}

TEST(FreeSpace, TakesTheFirstGapThatFits) {
  sim::FreeSpace space(10 * 4096);
  EXPECT_EQ(space.take(1), 0u);
  EXPECT_EQ(space.take(4097), 4096u);
  EXPECT_EQ(space.take(4096), 3u * 4096);
  space.give(4096);
  EXPECT_EQ(space.take(3 * 4096), 4u * 4096) << "the gap is too small";
  EXPECT_EQ(space.take(2 * 4096), 4096u);
  EXPECT_EQ(space.left(), 3u * 4096);
  EXPECT_EQ(space.take(4 * 4096), std::nullopt);
  EXPECT_EQ(space.take(~std::uint64_t{0}), std::nullopt);
  EXPECT_TRUE(space.holds(4096, 2 * 4096));
  EXPECT_FALSE(space.holds(4096, 2 * 4096 + 1)) << "another's";
  EXPECT_FALSE(space.holds(7 * 4096, 1));
  EXPECT_FALSE(space.holds(4097, ~std::uint64_t{0}));
  EXPECT_EQ(space.take(2 * 4096), 7u * 4096);
  EXPECT_EQ(space.take(0), 9u * 4096) << "an empty buffer has a place of its own";
  EXPECT_EQ(space.take(0), std::nullopt);
}

}  // namespace
}  // namespace castray::tb
