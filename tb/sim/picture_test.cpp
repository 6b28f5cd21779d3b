// SPDX-License-Identifier: Apache-2.0
// Pictures on disk: what was written is read back, raw bits as they were; nothing partial stays.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "folder_test.hpp"
#include "frame_run.hpp"
#include "mem/hit_writer.hpp"
#include "picture.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

namespace fs = std::filesystem;

class Pictures : public FolderTest {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const auto& entry : fs::directory_iterator(folder_)) list.push_back(entry.path().filename().string());
    return list;
  }

  const SceneImage image_ = compile(load_scene("scenes/spheres.json"), 16, 12);
  const sim::Rendering frame_ = sim::run_model(image_);
};

TEST_F(Pictures, PngComesBackWithItsMetadata) {
  const sim::Picture picture = sim::picture_of(frame_, PixelFormat::Rgba8);
  sim::write_picture(folder_ / "a.png", picture, {{"castray:seed", "17"}, {"castray:cycles", "123"}, {"castray:commit", "abc"}});
  const sim::Picture back = sim::read_picture(folder_ / "a.png");
  EXPECT_EQ(back.width, 16);
  EXPECT_EQ(back.height, 12);
  EXPECT_EQ(back.rgb, picture.rgb);
  const auto input = OIIO::ImageInput::open((folder_ / "a.png").string());
  EXPECT_EQ(input->spec().get_string_attribute("castray:seed"), "17");
  EXPECT_EQ(input->spec().get_string_attribute("castray:cycles"), "123");
  EXPECT_EQ(input->spec().get_string_attribute("castray:commit"), "abc");
  EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

TEST_F(Pictures, RedAndBlueFollowThePixelFormat) {
  sim::Rendering one;
  one.width = one.height = 1;
  one.pixels = {0xff030201};
  EXPECT_EQ(sim::picture_of(one, PixelFormat::Rgba8).rgb, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(sim::picture_of(one, PixelFormat::Bgra8).rgb, (std::vector<std::uint8_t>{3, 2, 1}));
}

// Every bit of every record; distances rounded once from double.
TEST_F(Pictures, ExrHoldsTheRecords) {
  sim::write_aov(folder_ / "a.exr", frame_, image_, {});
  const auto input = OIIO::ImageInput::open((folder_ / "a.exr").string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec spec = input->spec();
  ASSERT_EQ(spec.nchannels, 9);
  const auto channel = [&](const char* name, OIIO::TypeDesc type, void* data) {
    const int index = spec.channelindex(name);
    ASSERT_GE(index, 0) << name;
    EXPECT_EQ(spec.channelformat(index), type) << name;
    ASSERT_TRUE(input->read_image(0, 0, index, index + 1, type, data)) << name;
  };
  const std::size_t count = frame_.pixels.size();
  std::vector<std::uint32_t> t(count), u(count), v(count), prim(count), instance(count);
  channel("hit.t", OIIO::TypeDesc::UINT32, t.data());
  channel("hit.u", OIIO::TypeDesc::UINT32, u.data());
  channel("hit.v", OIIO::TypeDesc::UINT32, v.data());
  channel("hit.prim", OIIO::TypeDesc::UINT32, prim.data());
  channel("hit.instance", OIIO::TypeDesc::UINT32, instance.data());
  std::vector<float> distance(count), fu(count), fv(count), fprim(count);
  channel("t", OIIO::TypeDesc::FLOAT, distance.data());
  channel("u", OIIO::TypeDesc::FLOAT, fu.data());
  channel("v", OIIO::TypeDesc::FLOAT, fv.data());
  channel("prim", OIIO::TypeDesc::FLOAT, fprim.data());
  bool hit_seen = false, miss_seen = false;
  for (std::size_t i = 0; i < count; ++i) {
    const hit_record_t record = frame_.hit(i);
    EXPECT_EQ(t[i], static_cast<std::uint32_t>(record.t));
    EXPECT_EQ(u[i], record.u);
    EXPECT_EQ(v[i], record.v);
    EXPECT_EQ(prim[i], record.prim);
    EXPECT_EQ(instance[i], record.instance_id);
    const bool found = is_hit(record);
    (found ? hit_seen : miss_seen) = true;
    EXPECT_EQ(fprim[i], found ? static_cast<float>(record.prim) : -1.0f);
    EXPECT_EQ(fu[i], static_cast<float>(static_cast<double>(record.u) / (1 << 24)));
    EXPECT_EQ(fv[i], static_cast<float>(static_cast<double>(record.v) / (1 << 24)));
    if (found) EXPECT_EQ(distance[i], static_cast<float>(scene_distance(image_, static_cast<int>(i) % 16, static_cast<int>(i) / 16, record.t)));
    else EXPECT_TRUE(std::isinf(distance[i]) && distance[i] > 0);
  }
  EXPECT_TRUE(hit_seen && miss_seen);
}

TEST_F(Pictures, DistancesAreThoseOfTheReference) {
  const ReferenceFrame reference = trace_float64(load_scene("scenes/spheres.json"), 16, 12);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 16; ++x) {
      const hit_record_t record = frame_.hit(frame_.index(x, y));
      if (!is_hit(record)) continue;
      EXPECT_NEAR(scene_distance(image_, x, y, record.t), reference.at(x, y).t, 1e-4);
    }
  }
}

TEST_F(Pictures, FailuresLeaveNothingBehind) {
  const sim::Picture picture = sim::picture_of(frame_, PixelFormat::Rgba8);
  EXPECT_THROW(sim::write_picture(folder_ / "a.nonsense", picture, {}), sim::PictureError);
  EXPECT_THROW(sim::write_picture(folder_ / "no" / "a.png", picture, {}), sim::PictureError);
  EXPECT_THROW(sim::check_writable(folder_ / "no" / "a.png"), sim::PictureError);
  EXPECT_THROW(sim::check_writable(folder_), sim::PictureError);
  EXPECT_NO_THROW(sim::check_writable(folder_ / "a.png"));
  EXPECT_TRUE(names().empty());
  std::ofstream(folder_ / "old.png") << "what was there";
  EXPECT_NO_THROW(sim::check_writable(folder_ / "old.png"));
  EXPECT_EQ(fs::file_size(folder_ / "old.png"), 14u);
}

}  // namespace
}  // namespace castray::tb
