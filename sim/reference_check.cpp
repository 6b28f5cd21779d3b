// SPDX-License-Identifier: Apache-2.0
#include "reference_check.hpp"

#include <algorithm>
#include <cstdlib>

#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "camera/ray_setup.hpp"
#include "mem/hit_writer.hpp"
#include "mem/image.hpp"
#include "shade/shade.hpp"

namespace castray::sim {
namespace {

class Judge {
 public:
  Judge(const Scene& scene, const SceneImage& image)
      : scene_(scene), image_(image), camera_(frame_setup(image.frame)), paint_(frame_paint(image.frame)) {}

  // True if the model shows the second colour of the checker: its state at the hit, made again
  // from the hit record.
  bool second_colour(const hit_record_t& record, int x, int y) const {
    pixel_tag_t tag;
    tag.x = static_cast<std::uint64_t>(x);
    tag.y = static_cast<std::uint64_t>(y);
    const ray_t ray = ray_setup(ray_gen(camera_, x, y), camera_, tag);
    const attr_t attr = load_attr(image_.bytes.data(), image_.header, record.prim);
    hit_t hit;
    hit.found = 1;
    hit.kind = attr.kind;
    hit.number = record.prim;
    hit.t = record.t;
    hit.u = record.u;
    hit.v = record.v;
    hit.sx = ray.sx;
    hit.sy = ray.sy;
    hit.axis = ray.axis;
    hit.neg = ray.neg;
    return is_colour_b(shade_vectors(hit, attr, camera_.eye), paint_);
  }

  // True if the reference shows the second colour.
  bool second_colour(const ReferencePixel& pixel) const {
    const auto prim = static_cast<std::size_t>(pixel.prim);
    const std::size_t triangles = scene_.triangles.size();
    const Material material = prim < triangles ? scene_.triangles[prim].material : scene_.spheres[prim - triangles].material;
    return material == Material::Checker ? pixel.odd : material == Material::ColourB;
  }

  int distance(std::uint32_t word, const Rgb& colour) const {
    int worst = 0;
    for (int i = 0; i < 3; ++i) {
      const int channel = static_cast<int>(word >> (8 * (paint_.swap_rb ? 2 - i : i)) & 255);
      worst = std::max(worst, std::abs(channel - colour[static_cast<std::size_t>(i)]));
    }
    return worst;
  }

 private:
  const Scene& scene_;
  const SceneImage& image_;
  camera_t camera_;
  paint_t paint_;
};

}  // namespace

ReferenceCheck check_reference(const Scene& scene, const SceneImage& image, const Rendering& rendering, const ReferenceFrame& reference) {
  const Judge judge(scene, image);
  ReferenceCheck check;
  check.pixels = rendering.pixels.size();
  for (int y = 0; y < rendering.height; ++y) {
    for (int x = 0; x < rendering.width; ++x) {
      const std::size_t i = rendering.index(x, y);
      const hit_record_t record = rendering.hit(i);
      const ReferencePixel& expected = reference.at(x, y);
      const bool found = is_hit(record);
      check.hits += found;
      if (found != (expected.prim >= 0) || (found && record.prim != static_cast<std::uint64_t>(expected.prim))) {
        ++check.other_primitive;
        continue;
      }
      if (found && judge.second_colour(record, x, y) != judge.second_colour(expected)) {
        ++check.other_cell;
      } else {
        const int distance = judge.distance(rendering.pixels[i], expected.colour);
        check.far_colour += distance > 1;
        check.worst = std::max(check.worst, distance);
      }
    }
  }
  return check;
}

}  // namespace castray::sim
