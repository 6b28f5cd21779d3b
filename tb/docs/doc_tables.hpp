// SPDX-License-Identifier: Apache-2.0
// Reads the tables of a page of docs/ and the constants of a package, to compare the two. Run from
// the root of the tree, as all tests are.
#pragma once
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace castray::tb {

inline std::string file_text(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read: run the tests from the root of the tree");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// The rows of the table under the heading "## title", without its head.
inline std::vector<std::vector<std::string>> table_rows(const std::string& page, const std::string& title) {
  std::istringstream lines(page.substr(std::min(page.find("\n## " + title + "\n"), page.size())));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.starts_with("## ")) {
    if (!line.starts_with("|") || line.starts_with("|---")) continue;
    std::vector<std::string> row;
    std::istringstream text(line.substr(1));
    for (std::string field; std::getline(text, field, '|');) {
      const auto first = field.find_first_not_of(' ');
      row.push_back(first == std::string::npos ? "" : field.substr(first, field.find_last_not_of(' ') - first + 1));
    }
    rows.push_back(row);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

// Name and value of each constant or enumerator of a package whose name matches `pattern`. Values
// are literals there.
inline std::map<std::string, long> package_constants(const std::string& path, const std::string& pattern) {
  const std::string text = file_text(path);
  const std::regex entry("\\b(" + pattern + ")\\s*=\\s*(?:\\d*'([hd]))?([0-9a-fA-F]+)\\s*[;,\\n ]");
  std::map<std::string, long> constants;
  for (std::sregex_iterator it(text.begin(), text.end(), entry), end; it != end; ++it)
    constants[(*it)[1]] = std::stol((*it)[3], nullptr, (*it)[2] == "h" ? 16 : 10);
  return constants;
}

// The same of a table: the names of one column, the values of another.
inline std::map<std::string, long> table_constants(const std::vector<std::vector<std::string>>& rows, std::size_t name, std::size_t value) {
  std::map<std::string, long> constants;
  for (const auto& row : rows) constants[row.at(name)] = std::stol(row.at(value), nullptr, 0);
  return constants;
}

}  // namespace castray::tb
