// SPDX-License-Identifier: Apache-2.0
// What the commands of the program share.
#pragma once
#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "exit_code.hpp"
#include "frame_run.hpp"
#include "uio/open_board.hpp"

namespace castray::cli {

// Wrong input that no library noticed: what() is one line.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// As sim::open_board: a program that takes it can be given a core that is not on a board.
using OpenBoard = std::function<std::unique_ptr<sim::Device>(const sim::BoardOptions&)>;

// What the commands are given, and what they leave.
struct Context {
  std::string program;  // as it was called
  sim::RunRtl run_rtl;      // renders on the simulated core
  sim::QueryRtl query_rtl;  // answers lists on it
  OpenBoard open_board;     // the core of this board
  int code = kOk;
};

// Each adds one command to the program; its callback leaves the exit code in the context.
void add_render(CLI::App& app, Context& context);
void add_ray(CLI::App& app, Context& context);
void add_info(CLI::App& app, Context& context);
void add_compare(CLI::App& app, Context& context);
void add_compile(CLI::App& app, Context& context);
void add_query(CLI::App& app, Context& context);

// All of them; never throws.
int program(int argc, const char* const* argv, const sim::RunRtl& run_rtl = sim::run_rtl, const sim::QueryRtl& query_rtl = sim::query_rtl,
            const OpenBoard& open_board = sim::open_board);

}  // namespace castray::cli
