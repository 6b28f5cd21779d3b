// SPDX-License-Identifier: Apache-2.0
// Files are whole or not there; links are followed; pipes and devices stay what they are.
#include "scene/replacement.hpp"

#include <sys/stat.h>

#include <thread>

#include "scene/files.hpp"
#include "scene_test.hpp"

namespace castray {
namespace {

namespace fs = std::filesystem;

struct ReplacementFile : tb::SceneTest {
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})); }
};

TEST_F(ReplacementFile, TheOldOneStandsUntilTheNewOneIsWhole) {
  const fs::path file = put("a.txt", "old");
  {
    Replacement given_up(file);
    std::ofstream(given_up.name()) << "half";
    EXPECT_EQ(given_up.name().extension(), ".txt");
    EXPECT_EQ(read_file(file), "old");
  }
  EXPECT_EQ(files(), 1u);
  Replacement whole(file);
  std::ofstream(whole.name()) << "new";
  EXPECT_FALSE(whole.commit());
  EXPECT_EQ(read_file(file), "new");
  EXPECT_EQ(files(), 1u);
}

TEST_F(ReplacementFile, ALinkStaysALink) {
  fs::create_directory(folder_ / "elsewhere");
  put("elsewhere/a.txt", "old");
  fs::create_symlink("elsewhere/a.txt", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "elsewhere/a.txt"), "new");
  fs::create_symlink("elsewhere/b.txt", folder_ / "dangling");
  write_file(folder_ / "dangling", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "dangling"));
  EXPECT_EQ(read_file(folder_ / "elsewhere/b.txt"), "new");
}

TEST_F(ReplacementFile, APipeStaysAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(Replacement::check(pipe));
  std::string got;
  std::jthread reader([&] { std::getline(std::ifstream(pipe), got); });
  write_file(pipe, "through\n");
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(files(), 1u);
}

TEST_F(ReplacementFile, AFullDeviceIsReported) {
  fs::create_symlink("/dev/full", folder_ / "full");  // by a link: whatever is replaced lies in the test's folder
  EXPECT_EQ(error_of([&] { write_file(folder_ / "full", "text"); }), "full: write: No space left on device");
  EXPECT_TRUE(fs::is_symlink(folder_ / "full"));
}

TEST_F(ReplacementFile, ChecksLeaveNothingBehind) {
  EXPECT_FALSE(Replacement::check(folder_ / "new"));
  EXPECT_EQ(Replacement::check(folder_), std::errc::is_a_directory);
  EXPECT_EQ(Replacement::check(folder_ / "no" / "new"), std::errc::no_such_file_or_directory);
  EXPECT_EQ(Replacement::check(""), std::errc::is_a_directory);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace castray
