// SPDX-License-Identifier: Apache-2.0
// What the tests of castray query share.
#pragma once
#include <sstream>

#include "command_line.hpp"

namespace castray::tb {

// The fields of each line below the first.
inline std::vector<std::vector<std::string>> table(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back(1);
    for (const char c : line)
      if (c == ',') rows.back().emplace_back();
      else rows.back().back() += c;
  }
  return rows;
}

class QueryCommand : public CommandLine {
 protected:
  static inline const std::string kColumns = "ox,oy,oz,dx,dy,dz\n";
  static inline const std::string kCube = "query scenes/cube.json ";

  Outcome query(const std::string& arguments, const sim::QueryRtl& core) const { return run("query " + arguments, sim::run_rtl, core); }

  // The program with a file, or with what a shell leaves of it, as its standard input.
  Outcome with_input(const std::string& name, const std::string& arguments) const {
    const int kept = dup(STDIN_FILENO), in = open(name.c_str(), O_RDONLY);
    dup2(in, STDIN_FILENO);
    const Outcome outcome = run(arguments);
    dup2(kept, STDIN_FILENO);
    close(kept);
    close(in);
    return outcome;
  }
};

}  // namespace castray::tb
