// SPDX-License-Identifier: Apache-2.0
// Files are whole or not there; links are followed; pipes and devices stay what they are.
#include "scene/replacement.hpp"

#include <sys/stat.h>

#include <climits>
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

TEST_F(ReplacementFile, NamesAsLongAsANameMayBe) {
  const std::string longest(NAME_MAX, 'n');
  for (const std::string& name : {longest, longest.substr(0, 246), longest.substr(4) + ".txt", "n." + longest.substr(2)}) {
    EXPECT_FALSE(Replacement::check(folder_ / name)) << name.size();
    write_file(folder_ / name, name);
    EXPECT_EQ(read_file(folder_ / name), name);
  }
  EXPECT_EQ(Replacement(folder_ / (longest.substr(4) + ".txt")).name().extension(), ".txt");
  std::string letters = "x";
  while (letters.size() < NAME_MAX) letters += "\u00e9";  // of two bytes each: none is cut in half
  const std::string part = Replacement(folder_ / letters).name().filename().string();
  EXPECT_EQ(part.find("\xc3."), std::string::npos);
  EXPECT_EQ(Replacement::check(folder_ / (longest + "n")), std::errc::filename_too_long);
  EXPECT_EQ(files(), 4u);
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

TEST_F(ReplacementFile, WhatDoesNotEndIsNotReadForEver) {
  EXPECT_EQ(error_of([&] { read_file("/dev/zero", 1 << 20); }), "/dev/zero: read: more than 1048576 bytes, the most that are read");
  const fs::path file = put("a.txt", "12345");
  EXPECT_EQ(read_file(file, 5), "12345");
  EXPECT_EQ(error_of([&] { read_file(file, 4); }), "a.txt: read: more than 4 bytes, the most that are read");
  fs::resize_file(file, kMostFileBytes + 1);  // a hole: it takes no room
  EXPECT_EQ(error_of([&] { read_file(file); }), "a.txt: read: more than 4294967296 bytes, the most that are read");
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
