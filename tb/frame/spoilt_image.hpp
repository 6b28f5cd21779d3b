// SPDX-License-Identifier: Apache-2.0
// Scene images as no host writes them: seeded, in ways that have names.
#pragma once
#include <array>
#include <cstdlib>
#include <random>
#include <string>

#include "frame/random_scene.hpp"
#include "mem/image.hpp"
#include "scene/compile.hpp"

namespace castray::tb {

struct Spoilt {
  SceneImage image;        // its bytes; header and frame are still those of the good one
  std::uint64_t window;    // bytes that the job says the image has
  std::uint32_t steps;     // nodes that a ray may visit
  std::string text;
};

// Seeded random scenes, each with triangles, spheres and a hierarchy of some levels.
inline const SceneImage& image_to_spoil(unsigned which) {
  static const std::vector<SceneImage> images = [] {
    std::vector<SceneImage> some;
    for (unsigned seed = 0; some.size() < 8; ++seed) {
      const RandomScene random = random_scene(seed);
      if (random.scene.triangles.size() < 15 || random.scene.spheres.size() < 2) continue;
      some.push_back(compile(random.scene, 24, 16));
    }
    return some;
  }();
  return images[which % images.size()];
}

class Spoiler {
 public:
  static constexpr std::array<const char*, 15> kWays{"bits",       "header",   "frame record", "node bits", "line bits",
                                                     "attributes", "noise",    "reference",    "planes",    "number",
                                                     "sphere",     "sections", "window",       "shared",    "deep"};

  explicit Spoiler(unsigned seed) : seed_(seed), random_(seed * 0x9e3779b97f4a7c15u + 1) {}

  static unsigned way_of(unsigned seed) { return seed % kWays.size(); }

  Spoilt make() {
    out_.image = image_to_spoil(seed_ / kWays.size());
    header_ = out_.image.header;
    out_.window = out_.image.bytes.size();
    out_.steps = one_in(2) ? 0 : 4096;
    out_.text = "image " + std::to_string(seed_) + ", " + kWays[way_of(seed_)];
    switch (way_of(seed_)) {
      case 0: flip(0, bytes().size(), 8); break;
      case 1: flip(0, HeaderBytes, 2); break;
      case 2: flip(HeaderBytes, FrameBytes, 4); break;
      case 3: flip(header_.nodes.offset, header_.nodes.count * NodeBytes, 4); break;
      case 4: flip(header_.lines.offset, header_.lines.count * LineBytes, 4); break;
      case 5: flip(header_.attributes.offset, header_.attributes.count * AttrBytes, 64); break;
      case 6: noise(); break;
      case 7: reference(); break;
      case 8: planes(); break;
      case 9: number(); break;
      case 10: sphere(); break;
      case 11: sections(); break;
      case 12: out_.window = in(0, one_in(4) ? 300 : out_.window); break;
      case 13: shared(); break;
      default: deep();
    }
    return std::move(out_);
  }

 private:
  std::uint64_t in(std::uint64_t low, std::uint64_t high) { return low + random_() % (high - low + 1); }
  bool one_in(std::uint64_t n) { return random_() % n == 0; }
  std::vector<std::uint8_t>& bytes() { return out_.image.bytes; }

  void flip(std::uint64_t first, std::uint64_t size, std::uint64_t most) {
    for (std::uint64_t i = in(1, most); i > 0; --i) bytes()[first + in(0, size - 1)] ^= static_cast<std::uint8_t>(1 << in(0, 7));
  }

  void noise() {
    const std::uint64_t size = in(1, 256), first = in(HeaderBytes + FrameBytes, bytes().size() - size);
    for (std::uint64_t i = 0; i < size; ++i) bytes()[first + i] = static_cast<std::uint8_t>(random_());
  }

  template <class Record, class Change> void change(std::uint64_t offset, Change&& change) {
    Record record = load_record<Record>(&bytes()[offset]);
    change(record);
    store_record(&bytes()[offset], record);
  }
  template <class Change> void change_node(std::uint64_t index, Change&& change_it) {
    change<node_t>(header_.nodes.offset + index * NodeBytes, change_it);
  }
  template <class Change> void change_slot(Change&& change_it) {
    change<prim_slot_t>(header_.lines.offset + in(0, 2 * header_.lines.count - 1) * SlotBytes, change_it);
  }

  static std::uint64_t node_ref(std::uint64_t index) { return static_cast<std::uint64_t>(RefNode) << LineW | index; }
  static std::uint64_t leaf_ref(std::uint64_t index) { return static_cast<std::uint64_t>(RefLeaf) << LineW | index; }

  // A reference in the place of a node's, or of the root.
  std::uint64_t wrong_ref(std::uint64_t node) {
    const std::uint64_t nodes = header_.nodes.count, lines = header_.lines.count;
    switch (in(0, 11)) {
      case 0: return node_ref(node);                                     // itself
      case 1: return node_ref(in(0, node));                              // before it
      case 2: return node_ref(nodes);                                    // one behind the last
      case 3: return node_ref(in(nodes, (1u << LineW) - 1));
      case 4: return leaf_ref(lines);
      case 5: return leaf_ref(in(lines, (1u << LineW) - 1));
      case 6: return static_cast<std::uint64_t>(RefTile) << LineW | in(0, 63);
      case 7: return in(1, (1u << LineW) - 1);                           // to nothing, with an index
      case 8: return node_ref(in(0, nodes - 1)) | 1ull << in(24, 31);
      case 9: return 0;                                                  // the list of children ends here
      case 10: return leaf_ref(in(0, lines - 1));                        // another leaf
      default: return node_ref(in(node, nodes - 1));                     // another's child
    }
  }
  void reference() {
    const std::uint64_t node = in(0, header_.nodes.count - 1);
    if (one_in(3)) return change<image_header_t>(0, [&](image_header_t& h) { h.root = wrong_ref(0); });
    change_node(node, [&](node_t& n) {
      ref_word_t* const refs[] = {&n.ref0, &n.ref1, &n.ref2, &n.ref3};
      *refs[in(0, 3)] = wrong_ref(node);
    });
  }

  void planes() {
    change_node(in(0, header_.nodes.count - 1), [&](node_t& n) {
      const auto plane = [&](plane_t& p) { if (one_in(2)) p = in(0, 255); };
      for (child_box_t* const box : {&n.box0, &n.box1, &n.box2, &n.box3})
        plane(box->x0), plane(box->x1), plane(box->y0), plane(box->y1), plane(box->z0), plane(box->z1);
      for (plane_exp_t* const exp : {&n.exp_x, &n.exp_y, &n.exp_z})
        if (one_in(3)) *exp = in(0, one_in(4) ? 31 : MaxPlaneExp);
      for (coord_t* const from : {&n.x, &n.y, &n.z})
        if (one_in(4)) *from = in(0, (1u << CoordW) - 1);
    });
  }

  void number() {
    change_slot([&](prim_slot_t& slot) {
      const std::uint64_t count = header_.primitives;
      const std::uint64_t numbers[] = {count, in(count, NoPrim), NoPrim, NoPrim - 1, in(0, count - 1), 0};
      slot.number = numbers[in(0, 5)];
    });
  }

  void sphere() {
    for (std::uint64_t i = in(1, 4); i > 0; --i)
      change_slot([&](prim_slot_t& slot) {
        slot.kind = KindSphere;
        slot.b.x = in(0, (1u << CoordW) - 1) >> in(0, CoordW - 1);
        if (one_in(4)) slot.a = {.z = in(0, (1u << CoordW) - 1), .y = in(0, (1u << CoordW) - 1), .x = in(0, (1u << CoordW) - 1)};
      });
  }

  void sections() {
    change<image_header_t>(0, [&](image_header_t& h) {
      section_t* const all[] = {&h.lines, &h.attributes, &h.nodes};
      section_t& section = *all[in(0, 2)];
      switch (in(0, 5)) {
        case 0: h.image_bytes = in(0, h.image_bytes + 256); break;
        case 1: section.count = in(0, section.count); break;
        case 2: section.count += in(1, 8); break;
        case 3: section.offset = in(0, h.image_bytes / 256) * 256; break;
        case 4: section.offset = all[in(0, 2)]->offset; break;
        default: h.primitives = in(0, h.primitives);
      }
    });
  }

  // Nodes of a tree of our own, in place of the image's.
  void replace_nodes(const std::vector<node_t>& nodes) {
    const std::uint64_t first = (bytes().size() + ImageAlign - 1) / ImageAlign * ImageAlign;
    bytes().resize((first + nodes.size() * NodeBytes + ImageAlign - 1) / ImageAlign * ImageAlign);
    for (std::size_t i = 0; i < nodes.size(); ++i) store_record(&bytes()[first + i * NodeBytes], nodes[i]);
    out_.window = bytes().size();
    change<image_header_t>(0, [&](image_header_t& h) {
      h.nodes = {.offset = first, .count = nodes.size()};
      h.image_bytes = bytes().size();
      h.root = node_ref(0);
    });
  }
  // All of the scene in each of its boxes.
  node_t wide_node() {
    node_t node;
    node.exp_x = node.exp_y = node.exp_z = MaxPlaneExp;
    node.box0 = node.box1 = node.box2 = node.box3 = {.x0 = 0, .y0 = 0, .z0 = 0, .x1 = 255, .y1 = 255, .z1 = 255};
    return node;
  }
  std::uint64_t any_leaf() { return leaf_ref(in(0, header_.lines.count - 1)); }

  // Four times the same child, level by level: 4^20 visits out of 21 nodes.
  void shared() {
    std::vector<node_t> nodes(in(2, 21), wide_node());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::uint64_t child = i + 1 < nodes.size() ? node_ref(i + 1) : any_leaf();
      nodes[i].ref0 = nodes[i].ref1 = nodes[i].ref2 = nodes[i].ref3 = child;
    }
    replace_nodes(nodes);
    out_.steps = static_cast<std::uint32_t>(in(1, 2000));
  }

  // A child that is a node, and leaves, level by level: each leaves a frame on the stack.
  void deep() {
    std::vector<node_t> nodes(in(28, 60), wide_node());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i].ref0 = i + 1 < nodes.size() ? node_ref(i + 1) : any_leaf();
      nodes[i].ref1 = any_leaf();
      if (one_in(2)) nodes[i].ref2 = any_leaf();
    }
    replace_nodes(nodes);
  }

  unsigned seed_;
  std::mt19937_64 random_;
  image_header_t header_;
  Spoilt out_;
};

// As many as the environment's CASTRAY_IMAGES says, or `some`.
inline unsigned images_to_spoil(unsigned some) {
  const char* text = std::getenv("CASTRAY_IMAGES");
  return text ? static_cast<unsigned>(std::atol(text)) : some;
}

// What became of the images spoilt in each way.
struct SpoiltCounts {
  std::array<std::array<unsigned, 16>, Spoiler::kWays.size()> by_way{};

  void count(unsigned seed, error_t error) { ++by_way[Spoiler::way_of(seed)][static_cast<std::size_t>(error)]; }
  unsigned of(error_t error) const {
    unsigned sum = 0;
    for (const auto& way : by_way) sum += way[static_cast<std::size_t>(error)];
    return sum;
  }
  unsigned total() const {
    unsigned sum = 0;
    for (const auto& way : by_way)
      for (const unsigned count : way) sum += count;
    return sum;
  }
};

}  // namespace castray::tb
