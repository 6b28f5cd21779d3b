// SPDX-License-Identifier: Apache-2.0
// docs/scene-image.md says what castray_image_pkg says: every field at its place, every constant.
#include <gtest/gtest.h>

#include "castray_records.hpp"
#include "doc_tables.hpp"

namespace castray::tb {

class SceneImagePage : public testing::Test {
 protected:
  // The table under `title` lists the leaves of a record, lowest first: place (in units of `unit`
  // bits), width, name.
  template <class Record> void compare(const std::string& title, int unit, int bytes) {
    EXPECT_EQ(Record::kBits, 8 * bytes) << title;
    const auto rows = table_rows(page_, title);
    std::size_t row = 0;
    Record record;
    record.each_field([&](std::string_view name, auto&, int at, int bits, bool is_signed) {
      ASSERT_LT(row, rows.size()) << title << ": " << name << " is missing";
      EXPECT_EQ(rows[row].at(2), name) << title;
      EXPECT_EQ(std::stol(rows[row].at(0), nullptr, 0) * unit, at) << title << ": " << name;
      EXPECT_EQ(rows[row].at(1), std::to_string(bits) + (is_signed ? " signed" : "")) << title << ": " << name;
      ++row;
    });
    EXPECT_EQ(row, rows.size()) << title << " has rows that are no field";
  }
  std::string page_ = file_text("docs/scene-image.md");
};

TEST_F(SceneImagePage, ListsEveryFieldAtItsPlace) {
  compare<image_header_t>("Header", 8, HeaderBytes);
  compare<frame_record_t>("Frame record", 8, FrameBytes);
  compare<prim_slot_t>("Lines", 1, SlotBytes);
  compare<node_t>("Nodes", 1, NodeBytes);
  compare<attr_t>("Attributes", 1, AttrBytes);
  compare<hit_record_t>("Hit record", 8, HitBytes);
  compare<ray_record_t>("Ray record", 8, RayBytes);
}

TEST_F(SceneImagePage, ListsEveryConstant) {
  auto constants = package_constants("rtl/pkg/castray_image_pkg.sv", "[A-Z]\\w+");
  EXPECT_GE(constants.size(), 16u);
  EXPECT_EQ(table_constants(table_rows(page_, "Constants"), 0, 1), constants);
}

TEST_F(SceneImagePage, AlignsWordsOfTheByteRecords) {
  const auto aligned = [](std::string_view name, auto&, int at, int bits, bool) {
    EXPECT_EQ(at % std::min(bits, 64), 0) << name << " is not aligned to its own size";
  };
  image_header_t header;
  header.each_field(aligned);
  frame_record_t frame;
  frame.each_field(aligned);
  hit_record_t hit;
  hit.each_field(aligned);
  ray_record_t ray;
  ray.each_field(aligned);
}

}  // namespace castray::tb
