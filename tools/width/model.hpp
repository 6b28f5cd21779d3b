// SPDX-License-Identifier: Apache-2.0
// The model of the widths that this is compiled for: a view's errors, and cracks in closed meshes.
#pragma once
#include "camera/frame_setup.hpp"
#include "camera/ray_gen.hpp"
#include "isect/closed_meshes.hpp"
#include "scene/compile.hpp"
#include "shade/shade.hpp"
#include "traverse/lane.hpp"
#include "view.hpp"

namespace castray::width {

// Each ray against the primitives of its tile's list, or against all.
inline Errors model_errors(const View& view, bool all) {
  const ImageRecords records = image_records(view.scene, kWidth, kHeight);
  const camera_t camera = frame_setup(records.frame);
  const paint_t paint = frame_paint(records.frame);
  std::vector<const prim_slot_t*> by_number(view.scene.primitives());   // none: dropped on this grid
  for (const prim_slot_t& slot : records.slots) by_number[slot.number] = &slot;
  const auto lists = tile_lists(view.scene, 16 * records.grid.step());
  std::vector<std::vector<prim_slot_t>> slots(lists.size());
  for (std::size_t i = 0; i < lists.size() && !all; ++i)
    for (const std::size_t number : lists[i])
      if (by_number[number]) slots[i].push_back(*by_number[number]);

  return errors(view, [&](std::size_t tile, int x, int y) {
    const ray_t ray = ray_setup(ray_gen(camera, x, y), camera, {});
    std::uint64_t tests = 0;
    const hit_t hit = lane(ray, all ? records.slots : slots[tile], tests, [](const cand_t&, const result_t*) {});
    const std::uint64_t word = (hit.found ? shade(hit, records.attributes[hit.number], camera.eye, paint) : background(hit, paint)).colour;
    const rgb_t colour = rgb_of(word);
    return Pixel{hit.found ? static_cast<std::int32_t>(hit.number) : -1,
                 {static_cast<std::uint8_t>(colour.r), static_cast<std::uint8_t>(colour.g), static_cast<std::uint8_t>(colour.b)}};
  });
}

// Rays from inside through exact points of edges and corners that meet no triangle in front, or several.
struct Cracks {
  long none = 0, several = 0;
  Cracks operator+(const Cracks& other) const { return {none + other.none, several + other.several}; }
};
// meets(ray, face): does it meet the triangle in front of its origin?
template <class Meets> Cracks cracks(const tb::Mesh& mesh, long rays, Meets&& meets) {
  tb::Rng rng(1);
  Cracks found;
  for (long i = 0; i < rays; ++i) {
    const tb::AimedRay aimed = tb::aim(mesh, rng);
    int front = 0;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) front += meets(aimed, face);
    found.none += front == 0;
    found.several += front > 1;
  }
  return found;
}

inline Cracks model_cracks(const tb::Mesh& mesh, long rays) {
  const std::vector<prim_slot_t> slots = mesh.slots();
  return cracks(mesh, rays, [&](const tb::AimedRay& aimed, std::size_t face) {
    cand_t cand;
    if (!ray_prim(aimed.ray, slots[face], 0, cand)) return false;
    hit_ray_t ray;
    ray.norm2 = aimed.ray.norm2, ray.neg = aimed.ray.neg;
    result_t hit;
    return hit_unit(cand, ray, hit);
  });
}

}  // namespace castray::width
