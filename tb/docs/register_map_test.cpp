// SPDX-License-Identifier: Apache-2.0
// docs/register-map.md says what castray_reg_pkg and error_t say: every name once, no other.
#include <gtest/gtest.h>

#include "castray_records.hpp"
#include "doc_tables.hpp"

namespace castray::tb {

const char* const kRegisters = "rtl/pkg/castray_reg_pkg.sv";

class RegisterMap : public testing::Test {
 protected:
  std::map<std::string, long> table(const std::string& title, std::size_t name, std::size_t value) {
    const auto rows = table_rows(page_, title);
    EXPECT_FALSE(rows.empty()) << title;
    const auto constants = table_constants(rows, name, value);
    EXPECT_EQ(rows.size(), constants.size()) << "a name stands twice under " << title;
    return constants;
  }
  std::string page_ = file_text("docs/register-map.md");
};

TEST_F(RegisterMap, ListsEveryRegister) {
  auto constants = package_constants(kRegisters, "Reg[A-Z]\\w*");
  EXPECT_EQ(constants.erase("RegAddrW"), 1u);
  EXPECT_GE(constants.size(), 19u);
  EXPECT_EQ(table("Registers", 1, 0), constants);
}

// The comparison reads literals; an expression would slip by.
TEST_F(RegisterMap, ReadsEveryConstantOfThePackage) {
  const std::string text = file_text(kRegisters);
  std::size_t declared = 0;
  for (std::size_t at = text.find("localparam"); at != std::string::npos; at = text.find("localparam", at + 1)) ++declared;
  EXPECT_EQ(package_constants(kRegisters, "[A-Z]\\w*").size(), declared);
}

TEST_F(RegisterMap, SaysWhichAreReadOnly) {
  for (const auto& row : table_rows(page_, "Registers")) {
    const long offset = std::stol(row[0], nullptr, 0);
    EXPECT_EQ(row[2] == "read", (offset >= RegVersion && offset < RegRays) || offset >= RegCounters) << row[1];
  }
}

TEST_F(RegisterMap, ListsEveryBit) {
  EXPECT_EQ(table("Control bits", 1, 0), package_constants(kRegisters, "Ctrl\\w+"));
  EXPECT_EQ(table("Interrupt bits", 1, 0), package_constants(kRegisters, "Isr\\w+"));
  EXPECT_EQ(table("Option bits", 1, 0), package_constants(kRegisters, "Option\\w+"));
}

TEST_F(RegisterMap, ListsEveryCounterAtItsOffset) {
  auto constants = package_constants(kRegisters, "Cnt[A-Z]\\w*");
  EXPECT_EQ(constants.size(), static_cast<std::size_t>(Counters));
  for (auto& [name, value] : constants) value = RegCounters + 8 * value;
  EXPECT_EQ(table("Counters", 1, 0), constants);
}

TEST_F(RegisterMap, ListsEveryErrorCode) {
  const auto constants = package_constants("rtl/pkg/castray_pkg.sv", "Err[A-Z]\\w*");
  EXPECT_EQ(constants.size(), ErrRayWindow + 1u);
  EXPECT_EQ(table("Errors", 1, 0), constants);
  for (const auto& row : table_rows(page_, "Errors"))
    EXPECT_EQ(row[1] + ": " + row[2], meaning(static_cast<error_t>(std::stoi(row[0])))) << row[0];
}

}  // namespace castray::tb
