// SPDX-License-Identifier: Apache-2.0
// The scene image: grid, layout of its bytes, frame record, and what does not fit.
#include "scene/compile.hpp"

#include <random>

#include "fixed.hpp"
#include "flat_triangle.hpp"
#include "scene/camera.hpp"
#include "scene/frame.hpp"
#include "scene/grid.hpp"
#include "scene_test.hpp"

namespace castray {
namespace {

using tb::flat_triangle;

Scene small_scene() {
  Scene scene;
  scene.file = "s";
  scene.triangles.push_back(flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  look_at({0.25, 0.25, 3}, {0.25, 0.25, 0}, {0, 1, 0}, scene.camera.to_world);
  return scene;
}

template <class Record> Record read(const SceneImage& image, std::size_t at) {
  packed_t<Record> words{};
  for (std::size_t i = 0; i < 4 * words.size(); ++i) words[i / 4] |= std::uint32_t{image.bytes.at(at + i)} << (8 * (i % 4));
  return unpack<Record>(words.data());
}

struct Compile : tb::SceneTest {};

// ---- Grid ----

TEST_F(Compile, GridIsTheFinestThatFits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-30, 30), offset(-8, 8);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::exp2(exponent(random));
    const Vec3 low = Vec3(offset(random), offset(random), offset(random)) * size;
    const Vec3 high = low + Vec3(size, size / 3, size / 7);
    const Grid grid = finest_grid(low, high);
    const double span = high.x - low.x;
    EXPECT_LT(span / grid.step(), 0x1p26 - 64);
    EXPECT_GE(span / (grid.step() / 2), 0x1p26 - 64) << "one step finer fits as well";
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(Grid::holds(grid.at(low[axis], axis) - 31));
      EXPECT_TRUE(Grid::holds(grid.at(high[axis], axis) + 31));
    }
  }
}

TEST_F(Compile, GridAtItsLimit) {
  const double most = 0x1p26 - 64;
  EXPECT_EQ(finest_grid(Vec3(0), Vec3(most - 0.5, 0, 0)).power, 0);
  EXPECT_EQ(finest_grid(Vec3(0), Vec3(most, 0, 0)).power, 1);
  EXPECT_EQ(finest_grid(Vec3(-1, 0, 0), Vec3(most - 1, 0, 0)).power, 1);
}

TEST_F(Compile, GridOfTheTeapotsBaseView) { EXPECT_EQ(compile(load_scene("scenes/teapot.json"), 320, 240).header.grid_power, -22); }

TEST_F(Compile, OriginsOfAListTakeTheCamerasPlace) {
  const Scene scene = small_scene();
  const SceneImage frame = compile(scene, 4, 4), none = compile(scene, std::span<const ListRay>());
  EXPECT_EQ(frame.header.grid_power, -24);
  EXPECT_EQ(none.header.grid_power, -25) << "the triangle alone spans 1, with the eye 3";
  EXPECT_EQ(to_text(none.frame), to_text(frame_record_t{}));
  const ListRay rays[] = {{.origin = Vec3(0, 0, -40)}, {.origin = Vec3(0, 23, 0)}};
  const SceneImage list = compile(scene, rays);
  EXPECT_EQ(list.header.grid_power, -20);
  for (const ListRay& ray : rays)
    for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(Grid::holds(list.grid().at(ray.origin[axis], axis)));
  EXPECT_EQ(list.grid().step(), list.step());
}

TEST_F(Compile, OriginsTooFarAway) {
  const ListRay ray{.origin = Vec3(0x1p60, 0, 0)};
  EXPECT_EQ(error_of([&] { compile(small_scene(), std::span(&ray, 1)); }), "s: scene: nothing is left on a grid of 2^35: scene and the origins of rays lie too far apart");
}

// Far from the origin the grid is no finer than what a double can tell apart.
TEST_F(Compile, GridFarFromTheOrigin) {
  const Grid grid = finest_grid(Vec3(0x1p40), Vec3(0x1p40 + 1));
  EXPECT_EQ(grid.power, -11);
  EXPECT_EQ(grid.at(0x1p40, 0) - 32, 0);
}

TEST_F(Compile, ASceneTooSmallForTheFinestGrid) {
  const Scene scene = load_scene(put("s.json", R"({"spheres": [{"centre": [0, 0, 0], "radius": 1e-40}]})"));
  EXPECT_EQ(error_of([&] { compile(scene, 8, 8); }), "s.json: scene: nothing is left on a grid of 2^-100, the finest there is: the scene is too small");
}

TEST_F(Compile, GridOfAPoint) { EXPECT_EQ(finest_grid(Vec3(0), Vec3(0)).power, -100); }

TEST_F(Compile, GridRoundsToNearest) {
  Grid grid;
  EXPECT_EQ(grid.at(2.49, 0), 2);
  EXPECT_EQ(grid.at(2.51, 0), 3);
  EXPECT_EQ(grid.at(-2.51, 0), -3);
}

// ---- Layout ----

TEST_F(Compile, SectionsFollowEachOtherAligned) {
  Scene scene = small_scene();  // five pairs, far apart: a triangle and the same once more, or a sphere
  for (int i = 1; i < 9; ++i) {
    const Vec3 at(8 * (i / 2), 0, 0);
    scene.triangles.push_back(flat_triangle(at, at + Vec3(1, 0, 0), at + Vec3(0, 1, 0)));
  }
  scene.spheres.push_back({.centre = {32.5, 0.5, 0}, .radius = 0.5, .material = Material::ColourB});
  const SceneImage image = compile(scene, 33, 17);
  const image_header_t header = read<image_header_t>(image, 0);
  EXPECT_EQ(header, image.header);
  EXPECT_EQ(header.magic, 0x59525443u);
  EXPECT_EQ(std::string(image.bytes.begin(), image.bytes.begin() + 4), "CTRY");
  EXPECT_EQ(header.version, std::uint64_t{ImageVersion});
  EXPECT_EQ(header.parameters, std::uint64_t{ImageParameters});
  EXPECT_EQ(header.primitives, 10u);
  EXPECT_EQ(header.lines, (section_t{.offset = 256, .count = 5}));
  EXPECT_EQ(header.attributes, (section_t{.offset = 768, .count = 10}));  // 256 + 5 x 64, aligned
  EXPECT_EQ(header.nodes, (section_t{.offset = 1536, .count = 2}));       // 768 + 10 x 64, aligned
  EXPECT_EQ(header.image_bytes, 1792u);                                   // 1536 + 2 x 64, aligned
  EXPECT_EQ(header.root, 1u << 22);
  EXPECT_EQ(image.bytes.size(), 1792u);
  EXPECT_EQ(read<frame_record_t>(image, HeaderBytes), image.frame);
  for (std::size_t i = 0; i < 10; i += 2) {
    const auto first = read<prim_slot_t>(image, 256 + 32 * i), second = read<prim_slot_t>(image, 256 + 32 * (i + 1));
    EXPECT_EQ(first.number % 2, 0u);
    EXPECT_EQ(second.number, first.number + 1);
    EXPECT_EQ(second.kind, std::uint64_t(second.number == 9 ? KindSphere : KindTriangle));
  }
}

TEST_F(Compile, TriangleSlotAndAttributes) {
  Scene scene = small_scene();
  scene.triangles[0].normal[1] = Vec3(0.6, -0.8, 0);
  scene.triangles[0].tex = {Vec2(0.25, -1), Vec2(3.5, 1e-5), Vec2(-1023.99, 0)};
  scene.triangles[0].material = Material::ColourA;
  const SceneImage image = compile(scene, 320, 240);
  const auto steps = [&](double x) { return static_cast<std::uint64_t>(std::llround(x / image.step())); };
  const std::uint64_t ox = -image.header.corner_x, oy = -image.header.corner_y, oz = -image.header.corner_z;
  EXPECT_EQ(image.header.grid_power, -24);

  const auto slot = read<prim_slot_t>(image, image.header.lines.offset);
  EXPECT_EQ(slot.a, (point_t{.z = oz, .y = oy, .x = ox}));
  EXPECT_EQ(slot.b, (point_t{.z = oz, .y = oy, .x = ox + steps(1)}));
  EXPECT_EQ(slot.c, (point_t{.z = oz, .y = oy + steps(1), .x = ox}));
  EXPECT_EQ(slot.number, 0u);
  EXPECT_EQ(slot.kind, std::uint64_t{KindTriangle});

  const auto attr = read<attr_t>(image, image.header.attributes.offset);
  EXPECT_EQ(attr.na, (unit3_t{.z = 65536, .y = 0, .x = 0}));
  EXPECT_EQ(attr.nb, (unit3_t{.z = 0, .y = -52429, .x = 39322}));
  EXPECT_EQ(attr.face, attr.na);
  EXPECT_EQ(attr.sa, 16384);
  EXPECT_EQ(attr.ta, -65536);
  EXPECT_EQ(attr.sb, 229376);
  EXPECT_EQ(attr.tb, 1);
  EXPECT_EQ(attr.sc, -67108209);
  EXPECT_EQ(attr.material, 1u);
  EXPECT_EQ(attr.kind, 0u);

  const auto empty = read<prim_slot_t>(image, image.header.lines.offset + SlotBytes);
  EXPECT_EQ(empty.number, (1u << PrimW) - 1);  // a line of one primitive is filled up
}

TEST_F(Compile, SphereSlotAndAttributes) {
  Scene scene;
  scene.spheres.push_back({.centre = {1, 2, -3}, .radius = 0.75, .material = Material::ColourB});
  const SceneImage image = compile(scene, 320, 240);
  const auto slot = read<prim_slot_t>(image, image.header.lines.offset);
  EXPECT_EQ(slot.kind, std::uint64_t{KindSphere});
  EXPECT_EQ(double(slot.b.x) * image.step(), 0.75);
  EXPECT_EQ((double(slot.a.z) + double(image.header.corner_z)) * image.step(), -3);
  const auto attr = read<attr_t>(image, image.header.attributes.offset);
  EXPECT_EQ(attr.centre, slot.a);
  EXPECT_EQ(attr.material, 2u);
  EXPECT_EQ(attr.kind, 1u);
}

// The largest sphere that fits: its radius stays below 2^25 steps.
TEST_F(Compile, SpheresBoxCountsForTheGrid) {
  Scene scene;
  scene.spheres.push_back({.centre = {0, 0, 0}, .radius = 0x1p25 - 32.5});
  EXPECT_EQ(compile(scene, 1, 1).header.grid_power, 0);
  scene.spheres[0].radius = 0x1p25 - 32;
  EXPECT_EQ(compile(scene, 1, 1).header.grid_power, 1);
}

TEST_F(Compile, DegenerateOnTheGridLosesItsSlotAndKeepsItsNumber) {
  Scene scene = small_scene();
  scene.triangles.insert(scene.triangles.begin(), flat_triangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}));
  scene.spheres.push_back({.centre = {0, 0, 0}, .radius = 1e-12});
  scene.spheres.push_back({.centre = {0, 0, 0}, .radius = 0.5});
  const SceneImage image = compile(scene, 320, 240);
  EXPECT_EQ(image.dropped_triangles, 1u);
  EXPECT_EQ(image.dropped_spheres, 1u);
  EXPECT_EQ(image.warnings, (std::vector<std::string>{"s: 1 triangle dropped: degenerate on the grid of 2^-24",
                                                      "s: 1 sphere dropped: of radius zero on the grid of 2^-24"}));
  EXPECT_EQ(image.header.primitives, 4u);
  EXPECT_EQ(image.header.attributes.count, 4u);
  EXPECT_EQ(image.header.lines.count, 1u);
  EXPECT_EQ(read<prim_slot_t>(image, image.header.lines.offset).number, 1u);
  EXPECT_EQ(read<prim_slot_t>(image, image.header.lines.offset + SlotBytes).number, 3u);
}

// ---- Frame record ----

TEST_F(Compile, FrameRecord) {
  Scene scene = small_scene();
  scene.camera.field_of_view = 20;
  scene.paint.background = {1, 2, 3};
  scene.paint.checker_scale = 2.5;
  scene.pixel_format = PixelFormat::Bgra8;
  const SceneImage image = compile(scene, 321, 240);
  const frame_record_t& frame = image.frame;
  EXPECT_EQ(frame.width, 321u);
  EXPECT_EQ(frame.height, 240u);
  EXPECT_EQ(frame.stride, 1344u);  // 1,284 bytes up to a multiple of 64
  EXPECT_EQ(frame.pixel_format, 1u);
  EXPECT_EQ(frame.background, 0xff030201u);
  EXPECT_EQ(frame.checker_scale, 640u);
  EXPECT_EQ(frame.right_x, rot_t{1} << 30);
  EXPECT_EQ(frame.up_y, rot_t{1} << 30);
  EXPECT_EQ(frame.back_z, rot_t{1} << 30);
  EXPECT_EQ((double(frame.eye_z) + double(image.header.corner_z)) * image.step(), 3);
}

TEST_F(Compile, FocalAndPitchFillTheirRange) {
  Scene scene = small_scene();
  for (const double fov : {0.01, 1.0, 20.0, 90.0, 179.0})
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(320, 240), std::pair(4096, 1), std::pair(1, 4096), std::pair(4096, 4096)}) {
      scene.camera.field_of_view = fov;
      const frame_record_t frame = compile(scene, width, height).frame;
      const double largest = std::ldexp(std::max(double(frame.focal), double(frame.pitch) * std::max(width, height)), -44);
      EXPECT_GE(largest, 0.5);
      EXPECT_LT(largest, 1);
      EXPECT_EQ(frame.pitch & (frame.pitch - 1), 0u);
      EXPECT_NEAR(double(frame.focal), height / std::tan(fov * M_PI / 360) * double(frame.pitch), 0.51);
    }
}

TEST_F(Compile, MatrixIsScaledByAPowerOfTwo) {
  Scene scene = small_scene();
  scene.camera.to_world[0][0] = 0.003;
  scene.camera.to_world[1][1] = -0.006;
  scene.camera.to_world[2][2] = 0.001;
  const frame_record_t frame = compile(scene, 4, 4).frame;
  EXPECT_EQ(frame.right_x, std::llround(0.003 * 0x1p37));
  EXPECT_EQ(frame.up_y, std::llround(-0.006 * 0x1p37));
  EXPECT_EQ(frame.back_z, std::llround(0.001 * 0x1p37));
  EXPECT_LE(std::abs(frame.up_y), rot_t{1} << 30);
}

TEST_F(Compile, FrameRecordOfAnotherGrid) {
  Scene scene = small_scene();
  const Grid grid = finest_grid(Vec3(-1), Vec3(4));
  EXPECT_NO_THROW(frame_record(scene, grid, 64, 48));
  scene.camera.to_world[3][0] = 100;
  EXPECT_EQ(error_of([&] { frame_record(scene, grid, 64, 48); }), "s: camera: the eye at 100 lies outside the grid of the image");
}

TEST_F(Compile, DistanceOfAHit) {
  Scene scene = small_scene();  // the eye is 3 before the plane z = 0, and looks straight at it
  const SceneImage image = compile(scene, 3, 3);
  const auto t = static_cast<std::int64_t>(3 / image.step() * 16);
  EXPECT_DOUBLE_EQ(scene_distance(image, 1, 1, t), 3);
  const double side = 2.0 / 3 * std::tan(scene.camera.field_of_view * M_PI / 360);
  EXPECT_NEAR(scene_distance(image, 2, 1, t), 3 * std::sqrt(1 + side * side), 1e-9);
  EXPECT_NEAR(scene_distance(image, 0, 2, t), 3 * std::sqrt(1 + 2 * side * side), 1e-9);
}

// ---- What does not fit ----

TEST_F(Compile, FrameOfZeroOrAbsurdSize) {
  const Scene scene = small_scene();
  EXPECT_EQ(error_of([&] { compile(scene, 0, 1); }), "s: size: 0 x 1 is not between 1 x 1 and 4096 x 4096");
  EXPECT_EQ(error_of([&] { compile(scene, 1, -5); }), "s: size: 1 x -5 is not between 1 x 1 and 4096 x 4096");
  EXPECT_EQ(error_of([&] { compile(scene, 4097, 1); }), "s: size: 4097 x 1 is not between 1 x 1 and 4096 x 4096");
  EXPECT_EQ(compile(scene, 4096, 4096).frame.stride, 16384u);
}
TEST_F(Compile, EmptyScene) { EXPECT_EQ(error_of([] { compile(Scene{.file = "s"}, 1, 1); }), "s: scene: it holds no triangle and no sphere"); }
TEST_F(Compile, CameraTooFarAway) {
  Scene scene = small_scene();
  scene.camera.to_world[3][0] = 1e12;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: scene: nothing is left on a grid of 2^14: scene and camera lie too far apart");
  scene.camera.to_world[3][0] = 1e25;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: camera: the eye at 1e+25 is outside the number range, +-2^60");
  scene.camera.to_world[3][0] = NAN;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: camera: the eye at nan is outside the number range, +-2^60");
}
TEST_F(Compile, BadCameraMatrix) {
  Scene scene = small_scene();
  scene.camera.to_world[1][1] = INFINITY;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: camera: the matrix is not finite");
  // An axis that rounds to zero beside the others, and two that round to the same.
  const std::string singular = "s: camera: the matrix is singular in 30 fraction bits: its axes are too unequal or too nearly parallel";
  scene.camera.to_world[1][1] = 1e-12;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), singular);
  scene = small_scene();
  scene.camera.to_world[1][0] = scene.camera.to_world[0][0];
  scene.camera.to_world[1][1] = 1e-12;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), singular);
  scene.camera.to_world[1][1] = 0x1p-29;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "no error");
  scene.camera.field_of_view = 180;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: camera: field of view of 180 degrees is not between 0.01 and 179");
}
TEST_F(Compile, TextureCoordinateOutOfRange) {
  Scene scene = small_scene();
  scene.triangles.push_back(scene.triangles[0]);
  scene.triangles[1].tex[2].y = 1024;
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: triangle 1: texture coordinate 1024 is not between -1024 and 1024");
}
TEST_F(Compile, TooManyPrimitives) {
  Scene scene;
  scene.file = "s";
  scene.spheres.resize((std::size_t{1} << PrimW));
  EXPECT_EQ(error_of([&] { compile(scene, 1, 1); }), "s: scene: 2097152 primitives, at most 2097151 are possible");
}

}  // namespace
}  // namespace castray
