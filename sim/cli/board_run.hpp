// SPDX-License-Identifier: Apache-2.0
// The third engine: a core on a board.
#pragma once
#include <bit>
#include <chrono>
#include <string>

#include "command.hpp"
#include "driver.hpp"

namespace castray::cli {

struct BoardArguments {
  sim::BoardOptions options;
  double timeout = 10;  // seconds

  void add_to(CLI::App& command);
};

struct BoardFacts {
  std::string device;  // its description
  double seconds = 0;  // of the host, for the job alone
  int tile_log2 = DefaultTileLog2;  // of its core
};

// job(driver) on the board, with the image loaded.
template <class Job>
BoardFacts run_on_board(const Context& context, const BoardArguments& arguments, const SceneImage& image, Job&& job) {
  sim::BoardOptions options = arguments.options;
  options.patience.silence = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * arguments.timeout));
  const std::unique_ptr<sim::Device> device = context.open_board(options);
  sim::Driver driver(*device);
  driver.load(image);
  const std::uint32_t tile = device->read_reg(RegConfig) >> 16 & 0xff;
  const auto start = std::chrono::steady_clock::now();
  job(driver);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {device->description(), seconds, tile > 0 ? std::countr_zero(tile) : static_cast<int>(DefaultTileLog2)};
}

}  // namespace castray::cli
