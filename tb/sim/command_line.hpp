// SPDX-License-Identifier: Apache-2.0
// The program run in this process, in a folder of its own.
#pragma once
#include <fcntl.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "folder_test.hpp"

namespace castray::tb {

namespace fs = std::filesystem;

// What a run of the program came to.
struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

inline std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The words of a line as a shell reads them: blanks part them, but for those between single quotes; '' is an empty one.
inline std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, within = false;  // a word
  for (const char c : line) {
    const bool part = quoted || c != ' ';
    if (part && !within) words.emplace_back();
    within = part;
    if (c == '\'') quoted = !quoted;
    else if (part) words.back() += c;
  }
  return words;
}

class CommandLine : public FolderTest {
 protected:
  // The core that the tests build with waveforms (CORES_CHECKED in tools/core.mk).
  static constexpr const char* kWithWaves = " --lanes 1 --ports 1 --l2 0";
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return path(name);
  }
  // Runs the program in this process; its exit code.
  static int execute(const std::string& arguments, const sim::RunRtl& run_rtl = sim::run_rtl, const sim::QueryRtl& query_rtl = sim::query_rtl,
                     const cli::OpenBoard& open_board = sim::open_board) {
    const std::vector<std::string> words = shell_words(kProgram + " " + arguments);
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    return cli::program(static_cast<int>(argv.size()), argv.data(), run_rtl, query_rtl, open_board);
  }
  // The same, its two outputs caught in files.
  static Outcome run(const std::string& arguments, const sim::RunRtl& run_rtl = sim::run_rtl, const sim::QueryRtl& query_rtl = sim::query_rtl,
                     const cli::OpenBoard& open_board = sim::open_board) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = execute(arguments, run_rtl, query_rtl, open_board);
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
  }
  // Fails with `code` and one line that has all of `words`; leaves no file but those that were there.
  void expect_refused(const std::string& arguments, int code, const std::vector<std::string>& words) const {
    SCOPED_TRACE(arguments);
    const auto count = [&] { return std::distance(fs::recursive_directory_iterator(folder_), fs::recursive_directory_iterator{}); };
    const auto before = count();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const std::string& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " not in: " << outcome.err;
    EXPECT_EQ(count(), before) << "a file was left behind";
  }
  // A full disk, or a closed one: what nobody got is no success.
  static void expect_needs_output(const std::string& arguments) {
    SCOPED_TRACE(arguments);
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO), full = open("/dev/full", O_WRONLY);
    dup2(full, STDOUT_FILENO);
    testing::internal::CaptureStderr();
    const int code = execute(arguments);
    const std::string err = testing::internal::GetCapturedStderr();
    dup2(kept, STDOUT_FILENO);
    close(kept);
    close(full);
    std::clearerr(stdout);
    EXPECT_EQ(code, 6);
    EXPECT_NE(err.find("standard output"), std::string::npos) << err;
  }

  static inline const std::string kProgram = "castray";
};

}  // namespace castray::tb
