// SPDX-License-Identifier: Apache-2.0
#include "scene/compile.hpp"

#include <ImathBox.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "fixed.hpp"
#include "scene/bvh.hpp"
#include "scene/camera.hpp"
#include "scene/frame.hpp"
#include "scene/grid.hpp"
#include "scene/node.hpp"
#include "scene/text.hpp"

namespace castray {
namespace {

static_assert(image_header_t::kBits == 8 * HeaderBytes && frame_record_t::kBits == 8 * FrameBytes);
static_assert(prim_slot_t::kBits <= 8 * SlotBytes && attr_t::kBits <= 8 * AttrBytes);

constexpr std::uint64_t kNoNumber = (std::uint64_t{1} << PrimW) - 1;

template <class Record> void put(std::vector<std::uint8_t>& bytes, std::size_t at, const Record& record) {
  const auto words = pack(record);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (int k = 0; k < 4; ++k) bytes[at + 4 * i + std::size_t(k)] = static_cast<std::uint8_t>(words[i] >> (8 * k));
}

std::uint64_t aligned(std::uint64_t bytes) { return (bytes + ImageAlign - 1) / ImageAlign * ImageAlign; }

point_t grid_point(const Grid& grid, const Vec3& p) {
  point_t point;
  point.x = static_cast<std::uint64_t>(grid.at(p.x, 0));
  point.y = static_cast<std::uint64_t>(grid.at(p.y, 1));
  point.z = static_cast<std::uint64_t>(grid.at(p.z, 2));
  return point;
}

// No area on the grid, exactly.
bool degenerate(const prim_slot_t& slot) {
  using product_t = int_of<2 * CoordW + 2>;
  const auto d = [](std::uint64_t a, std::uint64_t b) { return static_cast<product_t>(static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b)); };
  const product_t ux = d(slot.b.x, slot.a.x), uy = d(slot.b.y, slot.a.y), uz = d(slot.b.z, slot.a.z);
  const product_t vx = d(slot.c.x, slot.a.x), vy = d(slot.c.y, slot.a.y), vz = d(slot.c.z, slot.a.z);
  return uy * vz == uz * vy && uz * vx == ux * vz && ux * vy == uy * vx;
}

unit3_t unit3(const Vec3& n) {
  const auto fixed = [](double x) { return std::llround(std::ldexp(x, UnitFrac)); };
  unit3_t unit;
  unit.x = fixed(n.x);
  unit.y = fixed(n.y);
  unit.z = fixed(n.z);
  return unit;
}

class Compiler {
 public:
  explicit Compiler(const Scene& scene) : scene_(scene) {}

  // Of a frame from the scene's camera, or of none: then for rays from the origins given.
  SceneImage image(std::optional<FrameSize> frame, std::span<const ListRay> rays) {
    place(frame, rays);
    std::vector<Box> boxes(slots_.size());
    std::ranges::transform(slots_, boxes.begin(), padded_box);
    lay_out(build_bvh(boxes));
    return std::move(image_);
  }
  ImageRecords records(FrameSize frame) {
    place(frame, {});
    return {grid_, std::move(slots_), std::move(attributes_), image_.frame};
  }

 private:
  void place(std::optional<FrameSize> frame, std::span<const ListRay> rays) {
    if (scene_.primitives() == 0) throw SceneError(scene_.file, "scene", "it holds no triangle and no sphere");
    if (scene_.primitives() > kNoNumber)
      throw SceneError(scene_.file, "scene", std::to_string(scene_.primitives()) + " primitives, at most " + std::to_string(kNoNumber) + " are possible");
    Imath::Box3d box;
    bounds(scene_, box.min, box.max);
    if (frame) box.extendBy(eye());
    for (const ListRay& ray : rays) box.extendBy(ray.origin);
    grid_ = finest_grid(box.min, box.max);
    if (frame) image_.frame = frame_record(scene_, grid_, frame->width, frame->height);
    primitives();
    if (slots_.empty())
      throw SceneError(scene_.file, "scene", "nothing is left on a grid of 2^" + std::to_string(grid_.power) +
                       (grid_.power == Grid::kFinestPower ? std::string(", the finest there is: the scene is too small")
                        : std::string(": scene and ") + (frame ? "camera" : "the origins of rays") + " lie too far apart"));
  }

  Vec3 eye() const {
    const Vec3 eye = scene_.camera.eye();
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(eye[i]) <= kLargestCoordinate)) throw SceneError(scene_.file, "camera", "the eye at " + text_of(eye[i]) + " is " + kOutside);
    return eye;
  }

  void primitives() {
    attributes_.reserve(scene_.primitives());
    for (const Triangle& triangle : scene_.triangles) {
      prim_slot_t slot;
      slot.a = grid_point(grid_, triangle.corner[0]);
      slot.b = grid_point(grid_, triangle.corner[1]);
      slot.c = grid_point(grid_, triangle.corner[2]);
      slot.number = attributes_.size();
      slot.kind = KindTriangle;
      if (degenerate(slot)) ++image_.dropped_triangles;
      else slots_.push_back(slot);

      attr_t attr;
      attr.na = unit3(triangle.normal[0]);
      attr.nb = unit3(triangle.normal[1]);
      attr.nc = unit3(triangle.normal[2]);
      attr.face = unit3(triangle.face);
      tex_t* const tex[][2] = {{&attr.sa, &attr.ta}, {&attr.sb, &attr.tb}, {&attr.sc, &attr.tc}};
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k) *tex[i][k] = texture(triangle.tex[i][k]);
      attr.material = static_cast<std::uint64_t>(triangle.material);
      attr.kind = KindTriangle;
      attributes_.push_back(attr);
    }
    for (const Sphere& sphere : scene_.spheres) {
      prim_slot_t slot;
      slot.a = grid_point(grid_, sphere.centre);
      slot.b.x = static_cast<std::uint64_t>(std::llround(sphere.radius / grid_.step()));
      slot.number = attributes_.size();
      slot.kind = KindSphere;
      if (slot.b.x == 0) ++image_.dropped_spheres;
      else slots_.push_back(slot);

      attr_t attr;
      attr.centre = slot.a;
      attr.material = static_cast<std::uint64_t>(sphere.material);
      attr.kind = KindSphere;
      attributes_.push_back(attr);
    }
    warn(image_.dropped_triangles, "triangle", "degenerate");
    warn(image_.dropped_spheres, "sphere", "of radius zero");
  }

  tex_t texture(double x) const {
    const double fixed = std::round(std::ldexp(x, UnitFrac));
    if (!(std::abs(fixed) < std::ldexp(kTextureEnd, UnitFrac)))
      throw SceneError(scene_.file, "triangle " + std::to_string(attributes_.size()),
                       "texture coordinate " + text_of(x) + " is not " + text_of(Limits{-kTextureEnd, kTextureEnd}));
    return static_cast<tex_t>(fixed);
  }

  void warn(std::size_t count, const char* noun, const char* state) {
    if (count != 0)
      image_.warnings.push_back(scene_.file + ": " + counted(count, noun) + " dropped: " + state + " on the grid of 2^" + std::to_string(grid_.power));
  }

  void lay_out(const Bvh& bvh) {
    image_header_t& header = image_.header;
    header.magic = ImageMagic;
    header.version = ImageVersion;
    header.parameters = ImageParameters;
    header.grid_power = grid_.power;
    header.primitives = attributes_.size();
    header.lines = {.offset = aligned(HeaderBytes + FrameBytes), .count = bvh.leaves.size()};
    header.attributes = {.offset = aligned(header.lines.offset + header.lines.count * LineBytes), .count = attributes_.size()};
    header.nodes = {.offset = aligned(header.attributes.offset + header.attributes.count * AttrBytes), .count = bvh.nodes.size()};
    header.image_bytes = aligned(header.nodes.offset + header.nodes.count * NodeBytes);
    header.root = ref_word(RefNode, 0);
    header.corner_x = grid_.corner[0];
    header.corner_y = grid_.corner[1];
    header.corner_z = grid_.corner[2];

    image_.bytes.assign(header.image_bytes, 0);
    put(image_.bytes, 0, header);
    put(image_.bytes, HeaderBytes, image_.frame);
    for (std::size_t i = 0; i < bvh.leaves.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        const std::uint32_t slot = bvh.leaves[i][k];
        put(image_.bytes, header.lines.offset + i * LineBytes + k * SlotBytes, slot == Bvh::kNone ? prim_slot_t{.number = kNoNumber} : slots_[slot]);
      }
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) put(image_.bytes, header.nodes.offset + i * NodeBytes, bvh.nodes[i]);
    for (std::size_t i = 0; i < attributes_.size(); ++i) put(image_.bytes, header.attributes.offset + i * AttrBytes, attributes_[i]);
  }

  const Scene& scene_;
  Grid grid_;
  std::vector<prim_slot_t> slots_;
  std::vector<attr_t> attributes_;
  SceneImage image_;
};

}  // namespace

Grid SceneImage::grid() const {
  return {.power = static_cast<int>(header.grid_power), .corner = {header.corner_x, header.corner_y, header.corner_z}};
}
double SceneImage::step() const { return grid().step(); }

ImageRecords image_records(const Scene& scene, int width, int height) { return Compiler(scene).records({width, height}); }
SceneImage compile(const Scene& scene, int width, int height) { return Compiler(scene).image(FrameSize{width, height}, {}); }
SceneImage compile(const Scene& scene, std::span<const ListRay> rays) { return Compiler(scene).image({}, rays); }

double scene_distance(const SceneImage& image, int x, int y, std::int64_t t) {
  const frame_record_t& f = image.frame;
  const double across = (2.0 * x + 1 - double(f.width)) * double(f.pitch);
  const double above = (double(f.height) - 2.0 * y - 1) * double(f.pitch);
  const double focal = double(f.focal);
  const Vec3 d = Vec3(f.right_x, f.right_y, f.right_z) * across + Vec3(f.up_x, f.up_y, f.up_z) * above - Vec3(f.back_x, f.back_y, f.back_z) * focal;
  const double dominant = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  return std::ldexp(double(t), -TFrac) * image.step() * (d.length() / dominant);
}

}  // namespace castray
