// SPDX-License-Identifier: Apache-2.0
// Drives a core through its registers and its memory, and through nothing else.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "device.hpp"
#include "fixed.hpp"
#include "scene/scene_image.hpp"

namespace castray::sim {

using Counts = std::array<std::uint64_t, Counters>;   // of a job

struct PixelWindow {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;  // one past the last
  int y1 = 0;
};

// How the primitives that a ray meets are found: in the hierarchy, from the start of its tile or from
// the root, or by testing all.
enum class Mode { kBvh, kBvhRoot, kBrute };
inline constexpr std::array<const char*, 3> kModeNames{"bvh", "bvh_root", "brute"};

struct RenderOptions {
  bool hits = true;
  bool work = false;                  // the hit records hold the nodes and tests of each ray
  bool z_order = false;
  Mode mode = Mode::kBvh;
  std::uint32_t steps = 0;            // nodes that a ray may visit; 0: no limit
  std::optional<PixelWindow> window;  // none: the whole frame
};

// The outcome of a job. On an error the buffers hold whatever the core had written by then.
struct Rendering {
  error_t error = ErrNone;
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;  // words of the frame buffer, row by row, top first
  std::vector<std::uint8_t> hits;     // raw records of all pixels, empty unless asked for
  Counts counters{};

  std::uint64_t cycles() const { return counters[CntCycles]; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); }
  hit_record_t hit(std::size_t pixel) const;
};

// A list of rays finds its hits in the hierarchy from the root (kBvh: the same) or by brute force.
struct QueryOptions {
  Mode mode = Mode::kBvhRoot;
  bool work = false;         // as of RenderOptions
  std::uint32_t steps = 0;   // nodes that a ray may visit; 0: no limit
};

// The outcome of a list, in its order. On an error the records hold whatever the core had written by then.
struct Answers {
  error_t error = ErrNone;
  std::vector<std::uint8_t> hits;   // raw records
  Counts counters{};

  std::uint64_t cycles() const { return counters[CntCycles]; }
  std::size_t size() const { return hits.size() / static_cast<std::size_t>(HitBytes); }
  hit_record_t hit(std::size_t ray) const;
};

// Records of rays as a list is handed over.
std::vector<std::uint8_t> bytes_of(std::span<const ray_record_t> rays);

class Driver {
 public:
  // Throws DeviceError unless the version and parameter registers are those of this build.
  explicit Driver(Device& device);
  ~Driver();
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  // Copies a scene image to the device, in place of the one before.
  void load(const SceneImage& image);
  // Renders it: start(), wait_interrupt, finish(). Throws DeviceError when the core hangs.
  Rendering render(const RenderOptions& options = {}, const Progress& progress = {});

  // Copies a list of rays to the device, raw ray_record_t, 1 to MaxRays, in place of the one before.
  void load_rays(std::span<const std::uint8_t> rays);
  // Its hits in the loaded image. Throws likewise.
  Answers query(std::span<const std::uint8_t> rays, const QueryOptions& options = {}, const Progress& progress = {});

  // The halves of the two, for whoever does something else meanwhile: start() is prepare() and go().
  void start(const RenderOptions& options);
  void prepare(const RenderOptions& options);
  Rendering finish();
  void start(std::span<const std::uint8_t> rays, const QueryOptions& options);
  Answers finish_query();
  // Writes an argument register by its castray_reg_pkg name, a pointer's two words.
  void set(std::int64_t reg, std::uint32_t value) { device_.write_reg(static_cast<unsigned>(reg), value); }
  void set_pointer(std::int64_t reg, std::uint64_t address);
  // Sets all arguments of a job on the loaded image, without starting it.
  void set_arguments(const RenderOptions& options);
  void set_list_arguments(const QueryOptions& options);   // on the loaded list
  void go();

  Device& device() { return device_; }
  const Buffer& image_buffer() const { return image_; }
  const Buffer& frame_buffer() const { return frame_; }
  const Buffer& hits_buffer() const { return hits_; }
  const Buffer& rays_buffer() const { return rays_; }
  const Buffer& answers_buffer() const { return answers_; }

 private:
  void release();
  void set_image(std::uint32_t steps);
  void wait(const Progress& progress);
  error_t end_job(Counts& counters);
  std::uint64_t counter(std::int64_t index);

  Device& device_;
  frame_record_t record_;
  Buffer image_;
  Buffer frame_;
  Buffer hits_;
  Buffer rays_;      // of a list
  Buffer answers_;
  bool want_hits_ = false;
};

}  // namespace castray::sim
