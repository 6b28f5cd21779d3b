// SPDX-License-Identifier: Apache-2.0
#include "scene/binary_tree.hpp"

#include <embree3/rtcore.h>

#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace castray {
namespace {

// Embree keeps a pointer for each node: the node's number plus one.
void* handle(std::size_t node) { return reinterpret_cast<void*>(node + 1); }
std::uint32_t node_of(void* handle) { return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(handle) - 1); }

BinaryTree& tree_of(void* user) { return *static_cast<BinaryTree*>(user); }

void* create_node(RTCThreadLocalAllocator, unsigned, void* user) {
  tree_of(user).emplace_back();
  return handle(tree_of(user).size() - 1);
}
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitive, std::size_t, void* user) {
  void* const leaf = create_node(allocator, 0, user);
  tree_of(user).back().left = primitive->primID;
  return leaf;
}
void set_children(void* node, void** children, unsigned, void* user) {
  tree_of(user)[node_of(node)].left = node_of(children[0]);
  tree_of(user)[node_of(node)].right = node_of(children[1]);
}
void set_bounds(void*, const RTCBounds**, unsigned, void*) {}  // made of integers: complete()

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};

// Floats have 24 bits: rounded outward. They decide the tree's shape only.
RTCBuildPrimitive build_primitive(const Box& box, std::size_t number) {
  const auto down = [](std::int64_t x) { return std::nextafter(float(x), -INFINITY); };
  const auto up = [](std::int64_t x) { return std::nextafter(float(x), INFINITY); };
  return {down(box.low[0]), down(box.low[1]), down(box.low[2]), 0, up(box.high[0]), up(box.high[1]), up(box.high[2]), static_cast<unsigned>(number)};
}

std::uint32_t balanced_height(std::uint32_t count) { return static_cast<std::uint32_t>(std::bit_width(count - 1)); }

// Divides the boxes below a node evenly.
class Balancer {
 public:
  explicit Balancer(BinaryTree& tree) : tree_(tree) {}

  void balance(std::uint32_t node) {
    leaves_.clear();
    free_.clear();
    gather(node);
    std::ranges::sort(free_);  // so that children stay behind their parents
    next_ = 0;
    divide(0, leaves_.size());
  }

 private:
  void gather(std::uint32_t root) {
    std::vector<std::uint32_t> todo = {root};
    while (!todo.empty()) {
      const std::uint32_t at = todo.back();
      todo.pop_back();
      free_.push_back(at);
      if (tree_[at].leaf()) leaves_.push_back(tree_[at]);
      else todo.insert(todo.end(), {tree_[at].right, tree_[at].left});
    }
  }
  std::uint32_t divide(std::size_t first, std::size_t end) {
    const std::uint32_t at = free_[next_++];
    if (end - first == 1) {
      tree_[at] = leaves_[first];
      return at;
    }
    const std::size_t middle = (first + end) / 2;
    const std::uint32_t left = divide(first, middle);
    const std::uint32_t right = divide(middle, end);
    tree_[at] = {.left = left, .right = right};
    return at;
  }

  BinaryTree& tree_;
  std::vector<BinaryNode> leaves_;
  std::vector<std::uint32_t> free_;  // the subtree's nodes, to be used again
  std::size_t next_ = 0;
};

}  // namespace

BinaryTree binary_tree(const std::vector<Box>& boxes) {
  // One thread: the callbacks append to one tree, and its order does not depend on the machine.
  const std::unique_ptr<RTCDeviceTy, Release> device(rtcNewDevice("threads=1"));
  const std::unique_ptr<RTCBVHTy, Release> bvh(device ? rtcNewBVH(device.get()) : nullptr);
  if (!bvh) throw std::runtime_error("Embree cannot be started: error " + std::to_string(rtcGetDeviceError(device.get())));
  std::vector<RTCBuildPrimitive> primitives(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) primitives[i] = build_primitive(boxes[i], i);
  BinaryTree tree;
  tree.reserve(2 * boxes.size());

  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxDepth = 1024;  // limit_height() sees to it
  arguments.maxLeafSize = 1;
  arguments.bvh = bvh.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  arguments.userPtr = &tree;
  if (!rtcBuildBVH(&arguments)) throw std::runtime_error("Embree builds no hierarchy: error " + std::to_string(rtcGetDeviceError(device.get())));
  for (BinaryNode& node : tree)
    if (node.leaf()) node.box = boxes[node.left];
  complete(tree);
  return tree;
}

void complete(BinaryTree& tree) {
  for (auto node = tree.rbegin(); node != tree.rend(); ++node) {
    if (node->leaf()) continue;
    const BinaryNode &left = tree[node->left], &right = tree[node->right];
    node->box = left.box;
    node->box.add(right.box);
    node->count = left.count + right.count;
    node->height = 1 + std::max(left.height, right.height);
  }
}

void limit_height(BinaryTree& tree, std::uint32_t most) {
  Balancer balancer(tree);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> todo = {{0, most}};  // node, levels left
  while (!todo.empty()) {
    const auto [at, levels] = todo.back();
    todo.pop_back();
    const BinaryNode& node = tree[at];
    if (node.height <= levels) continue;
    const std::uint32_t larger = std::max(tree[node.left].count, tree[node.right].count);
    if (1 + balanced_height(larger) > levels) balancer.balance(at);
    else todo.insert(todo.end(), {{node.left, levels - 1}, {node.right, levels - 1}});
  }
  complete(tree);
}

}  // namespace castray
