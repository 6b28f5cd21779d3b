// SPDX-License-Identifier: Apache-2.0
// What must fail does fail: one wrong bit of one pixel or one hit record is found and named.
#include <gtest/gtest.h>

#include "comparison.hpp"
#include "reference_check.hpp"
#include "frame_run.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace castray::tb {
namespace {

const SceneImage& image() {
  static const SceneImage image = compile(load_scene("scenes/cube.json"), 20, 15);
  return image;
}
const sim::Rendering& frame() {
  static const sim::Rendering rendering = sim::run_model(image());
  return rendering;
}

TEST(Comparison, EqualFramesAreEqual) {
  const sim::Comparison comparison = sim::compare(frame(), frame());
  EXPECT_TRUE(comparison.equal());
  EXPECT_TRUE(comparison.first.empty());
}

TEST(Comparison, OneBitOfAPixel) {
  sim::Rendering other = frame();
  other.pixels[137] ^= 1;
  const sim::Comparison comparison = sim::compare(other, frame());
  EXPECT_EQ(comparison.pixels_differ, 1u);
  EXPECT_EQ(comparison.hits_differ, 0u);
  EXPECT_EQ(comparison.first, std::vector<std::size_t>{137});
}

TEST(Comparison, OneBitOfAHitRecordItsReservedBytesToo) {
  for (const std::size_t byte : {0, 4, 8, 12, 16, 20, 31}) {
    sim::Rendering other = frame();
    other.hits[42 * HitBytes + byte] ^= 0x80;
    const sim::Comparison comparison = sim::compare(other, frame());
    EXPECT_EQ(comparison.pixels_differ, 0u);
    EXPECT_EQ(comparison.hits_differ, 1u) << byte;
    EXPECT_EQ(comparison.first, std::vector<std::size_t>{42});
  }
}

TEST(Comparison, OtherSizesDifferEverywhere) {
  const sim::Rendering other = sim::run_model(compile(load_scene("scenes/cube.json"), 15, 20));
  EXPECT_EQ(sim::compare(other, frame()).pixels_differ, 300u);
}

// One of each that does not depend on time is named with both values; the others are passed over.
TEST(Comparison, CountersOfWork) {
  sim::Counts other = frame().counters;
  ++other[CntCycles], ++other[CntReadBeats], ++other[CntNodeHits];
  EXPECT_EQ(sim::counters_that_differ(other, frame().counters), std::vector<std::string>{});
  for (const auto counter : {CntTests, CntRays, CntHits, CntCandidates, CntNodes, CntTileNodes, CntEmptyTiles}) {
    other = frame().counters;
    ++other[static_cast<std::size_t>(counter)];
    EXPECT_EQ(sim::counters_that_differ(other, frame().counters).size(), 1u) << counter;
  }
  other = frame().counters;
  other[CntHits] = 5;
  EXPECT_EQ(sim::counters_that_differ(other, frame().counters),
            std::vector<std::string>{"counter hits: 5, in the model " + std::to_string(frame().counters[CntHits])});
}

// The model counts as a core with tiles of the size that is asked for.
TEST(Comparison, TheModelsTilesAreTheCores) {
  const sim::Rendering small = sim::run_model(image(), {}, {}, 1, 2);
  EXPECT_TRUE(sim::compare(small, frame()).equal());
  EXPECT_GT(small.counters[CntTileNodes], frame().counters[CntTileNodes]);
}

// The reference check counts each kind of difference where it belongs.
class ReferenceCheck : public testing::Test {
 protected:
  const Scene scene_ = load_scene("scenes/cube.json");
  const ReferenceFrame reference_ = trace_float64(scene_, 20, 15);
  sim::ReferenceCheck check(const sim::Rendering& rendering) { return sim::check_reference(scene_, image(), rendering, reference_); }

  // A pixel that hits, or one that does not.
  std::size_t pixel(bool hit) const {
    std::size_t i = 0;
    while ((reference_.pixels[i].prim >= 0) != hit) ++i;
    return i;
  }
};

TEST_F(ReferenceCheck, CleanFrame) {
  const sim::ReferenceCheck result = check(frame());
  EXPECT_EQ(result.hits, reference_.hits);
  EXPECT_EQ(result.other_primitive + result.other_cell + result.far_colour, 0u);
  EXPECT_LE(result.worst, 1);
}

TEST_F(ReferenceCheck, AnotherPrimitive) {
  sim::Rendering other = frame();
  other.hits[pixel(true) * HitBytes + 12] ^= 1;
  EXPECT_EQ(check(other).other_primitive, 1u);
  other = frame();
  other.hits[pixel(false) * HitBytes + 12] = 0;
  EXPECT_EQ(check(other).other_primitive, 1u) << "a hit against a miss";
}

TEST_F(ReferenceCheck, FarColour) {
  for (const bool hit : {true, false}) {
    for (const int channel : {0, 8, 16}) {
      sim::Rendering other = frame();
      other.pixels[pixel(hit)] ^= 0x10u << channel;
      EXPECT_EQ(check(other).far_colour, 1u);
      EXPECT_GE(check(other).worst, 15);
    }
  }
}

}  // namespace
}  // namespace castray::tb
