// SPDX-License-Identifier: Apache-2.0
// A scene image from a file is the image that was compiled; one that this program cannot read is refused in one line.
#include "scene/scene_image.hpp"

#include "mem/image.hpp"
#include "scene/compile.hpp"
#include "scene/files.hpp"
#include "scene/load.hpp"
#include "folder_test.hpp"

namespace castray::tb {
namespace {

class SceneImageFile : public FolderTest {
 protected:
  std::string write(const std::vector<std::uint8_t>& bytes) const {
    const std::string file = (folder_ / "a.image").string();
    write_file(file, std::string(bytes.begin(), bytes.end()));
    return file;
  }
  void expect_refused(const std::vector<std::uint8_t>& bytes, const std::string& word) const {
    try {
      read_image(write(bytes));
      ADD_FAILURE() << "not refused: " << word;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("a.image"), std::string::npos) << error.what();
    }
  }
};

TEST_F(SceneImageFile, IsWhatWasCompiled) {
  const SceneImage image = compile(load_scene("scenes/cube.json"), 80, 60);
  const SceneImage back = read_image(write(image.bytes));
  EXPECT_EQ(back.bytes, image.bytes);
  EXPECT_EQ(back.header, image.header);
  EXPECT_EQ(back.frame, image.frame);
  const SceneImage list = compile(load_scene("scenes/cube.json"), std::span<const ListRay>());
  EXPECT_EQ(read_image(write(list.bytes)).bytes, list.bytes) << "of a list of rays";
}

TEST_F(SceneImageFile, AnotherIsRefused) {
  const std::vector<std::uint8_t> bytes = compile(load_scene("scenes/cube.json"), 80, 60).bytes;
  const auto with = [&](std::size_t at, std::uint8_t value) {
    std::vector<std::uint8_t> other = bytes;
    other[at] = value;
    return other;
  };
  expect_refused({}, "no scene image");
  expect_refused(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 100), "no scene image");
  expect_refused(with(0, 0), "no scene image");
  expect_refused(with(4, 99), "another version");
  expect_refused(with(8, static_cast<std::uint8_t>(bytes[8] + 1)), "other bit widths");
  expect_refused(std::vector<std::uint8_t>(bytes.begin(), bytes.end() - 256), "section");
  std::vector<std::uint8_t> wide = bytes;
  frame_record_t frame = load_frame_record(wide.data());
  frame.width = static_cast<std::uint64_t>(MaxFrameSize) + 1;
  frame.stride = 1 << 16;
  store_record(&wide[static_cast<std::size_t>(HeaderBytes)], frame);
  expect_refused(wide, "frame record");
  EXPECT_THROW(read_image(folder_ / "none"), SceneError);
}

}  // namespace
}  // namespace castray::tb
