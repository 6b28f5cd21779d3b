// SPDX-License-Identifier: Apache-2.0
#include "reference/embree.hpp"

#include <embree3/rtcore.h>

#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>

#include "reference/pixel_ray.hpp"

namespace castray {
namespace {

constexpr unsigned kTriangles = 0, kSpheres = 1;  // geometry numbers

// Processor time: other programs do not disturb it.
double now() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Embree's packet types by their number of rays, and a block of pixels of that size.
template <int N> struct Packet;
template <> struct Packet<4> {
  using Rays = RTCRayHit4;
  static constexpr int kColumns = 2;
  static constexpr auto* intersect = rtcIntersect4;
};
template <> struct Packet<8> {
  using Rays = RTCRayHit8;
  static constexpr int kColumns = 4;
  static constexpr auto* intersect = rtcIntersect8;
};
template <> struct Packet<16> {
  using Rays = RTCRayHit16;
  static constexpr int kColumns = 4;
  static constexpr auto* intersect = rtcIntersect16;
};

int number(unsigned geometry, unsigned primitive, const Scene& scene) {
  if (geometry == RTC_INVALID_GEOMETRY_ID) return -1;
  return static_cast<int>(primitive + (geometry == kSpheres ? scene.triangles.size() : 0));
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

template <int N> EmbreeFrame packets(const Scene& scene, RTCScene embree, int width, int height) {
  constexpr int kColumns = Packet<N>::kColumns, kRows = N / kColumns;
  const int across = (width + kColumns - 1) / kColumns, down = (height + kRows - 1) / kRows;
  struct Block {
    typename Packet<N>::Rays rays;
    alignas(64) int valid[N];
  };
  std::vector<Block> blocks(std::size_t(across) * std::size_t(down));
  const Vec3 eye = scene.camera.eye();
  const auto each_pixel = [&](auto&& f) {  // f(block, place, x, y)
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (int i = 0; i < N; ++i)
        f(blocks[b], i, static_cast<int>(b) % across * kColumns + i % kColumns, static_cast<int>(b) / across * kRows + i / kColumns);
  };
  each_pixel([&](Block& block, int i, int x, int y) {
    auto& [ray, hit] = block.rays;
    const Vec3 d = pixel_direction(scene, width, height, x, y);
    ray.org_x[i] = float(eye.x), ray.org_y[i] = float(eye.y), ray.org_z[i] = float(eye.z);
    ray.dir_x[i] = float(d.x), ray.dir_y[i] = float(d.y), ray.dir_z[i] = float(d.z);
    ray.tnear[i] = ray.time[i] = 0;
    ray.tfar[i] = std::numeric_limits<float>::infinity();
    ray.mask[i] = ~0u, ray.flags[i] = 0;
    hit.geomID[i] = hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    block.valid[i] = x < width && y < height ? -1 : 0;
  });

  EmbreeFrame frame;
  RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  const double start = now();
  for (Block& block : blocks) Packet<N>::intersect(block.valid, embree, &context, &block.rays);
  frame.seconds = now() - start;
  frame.prims.resize(std::size_t(width) * std::size_t(height));
  each_pixel([&](const Block& block, int i, int x, int y) {
    if (block.valid[i]) frame.prims[std::size_t(y) * std::size_t(width) + std::size_t(x)] = number(block.rays.hit.geomID[i], block.rays.hit.primID[i], scene);
  });
  return frame;
}

EmbreeFrame singles(const Scene& scene, RTCScene embree, int width, int height) {
  std::vector<RTCRayHit> rays(std::size_t(width) * std::size_t(height));
  const Vec3 eye = scene.camera.eye();
  for (int y = 0, i = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++i) {
      RTCRay& ray = rays[std::size_t(i)].ray;
      const Vec3 d = pixel_direction(scene, width, height, x, y);
      ray = {.org_x = float(eye.x), .org_y = float(eye.y), .org_z = float(eye.z), .tnear = 0, .dir_x = float(d.x), .dir_y = float(d.y),
             .dir_z = float(d.z), .time = 0, .tfar = std::numeric_limits<float>::infinity(), .mask = ~0u, .id = 0, .flags = 0};
      rays[std::size_t(i)].hit.geomID = rays[std::size_t(i)].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    }
  EmbreeFrame frame;
  RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  const double start = now();
  for (RTCRayHit& ray : rays) rtcIntersect1(embree, &context, &ray);
  frame.seconds = now() - start;
  for (const RTCRayHit& ray : rays) frame.prims.push_back(number(ray.hit.geomID, ray.hit.primID, scene));
  return frame;
}

}  // namespace

struct Embree::Handles {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  double build_seconds = 0;
  ~Handles() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  // A geometry with one buffer of vertices; `fill` writes them.
  template <class Fill> void attach(RTCGeometryType type, unsigned id, RTCFormat format, std::size_t floats, std::size_t count, Fill&& fill) {
    if (count == 0) return;
    const RTCGeometry geometry = rtcNewGeometry(device, type);
    fill(static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, format, floats * sizeof(float), count)), geometry);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }
};

Embree::Embree(const Scene& scene) : scene_(scene), handles_(std::make_unique<Handles>()) {
  const double start = now();
  rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
  const std::size_t triangles = scene.triangles.size();
  handles_->attach(RTC_GEOMETRY_TYPE_TRIANGLE, kTriangles, RTC_FORMAT_FLOAT3, 3, 3 * triangles, [&](float* vertices, RTCGeometry geometry) {
    for (const Triangle& triangle : scene.triangles)
      for (const Vec3& corner : triangle.corner)
        for (int axis = 0; axis < 3; ++axis) *vertices++ = float(corner[axis]);
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles));
    for (unsigned i = 0; i < 3 * triangles; ++i) *index++ = i;
  });
  handles_->attach(RTC_GEOMETRY_TYPE_SPHERE_POINT, kSpheres, RTC_FORMAT_FLOAT4, 4, scene.spheres.size(), [&](float* vertices, RTCGeometry) {
    for (const Sphere& sphere : scene.spheres) {
      for (int axis = 0; axis < 3; ++axis) *vertices++ = float(sphere.centre[axis]);
      *vertices++ = float(sphere.radius);
    }
  });
  rtcCommitScene(handles_->scene);
  handles_->build_seconds = now() - start;
  if (const RTCError error = rtcGetDeviceError(handles_->device); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree takes no such scene: error " + std::to_string(error));
}

Embree::~Embree() = default;

double Embree::build_seconds() const { return handles_->build_seconds; }

EmbreeFrame Embree::frame(int width, int height, int packet) const {
  switch (packet) {
    case 1: return singles(scene_, handles_->scene, width, height);
    case 4: return packets<4>(scene_, handles_->scene, width, height);
    case 8: return packets<8>(scene_, handles_->scene, width, height);
    case 16: return packets<16>(scene_, handles_->scene, width, height);
  }
  throw std::invalid_argument("Embree has packets of 1, 4, 8 and 16 rays");
}

}  // namespace castray
