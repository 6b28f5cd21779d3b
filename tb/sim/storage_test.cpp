// SPDX-License-Identifier: Apache-2.0
// Buffers of a simulated device: what lies beside one is not found.
#include "storage.hpp"

#include <gtest/gtest.h>

namespace castray::tb {
namespace {

TEST(Storage, BuffersHaveEdges) {
  sim::Storage storage;
  const sim::Buffer first = storage.allocate(100), second = storage.allocate(100);
  EXPECT_GT(first.address, std::uint64_t{1} << 32);
  EXPECT_NE(storage.find(first.address + 99, 1), nullptr);
  EXPECT_EQ(storage.find(first.address + 99, 2), nullptr);
  EXPECT_EQ(storage.find(first.address - 1, 1), nullptr);
  EXPECT_EQ(storage.find(first.address + 4096, 1), nullptr);
  EXPECT_NE(storage.find(second.address, 100), nullptr);
  storage.release(second);
  EXPECT_EQ(storage.find(second.address, 1), nullptr);
  EXPECT_THROW(storage.write(second.address, std::vector<std::uint8_t>(1)), std::out_of_range);
}

}  // namespace
}  // namespace castray::tb
