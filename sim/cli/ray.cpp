// SPDX-License-Identifier: Apache-2.0
// castray ray: one ray, stage by stage, the model's values beside the RTL's.
#include <cstdio>

#include "arguments.hpp"
#include "core.hpp"
#include "driver.hpp"
#include "error_text.hpp"
#include "model_device.hpp"
#include "probe.hpp"
#include "reference/float64.hpp"
#include "rtl_device.hpp"
#include "scene/compile.hpp"

namespace castray::cli {
namespace {

struct Arguments {
  SceneArguments scene;
  CoreArguments core;
  int x = 0;
  int y = 0;
  std::string trace;
  int limit = 20;
};

// A record's fields one by one; those of a stream that numbers places, not values, are left out.
struct Field {
  std::string name;
  std::string value;
};
template <class Record> std::vector<Field> fields(const Record& record) {
  std::vector<Field> list;
  record.each_field([&](std::string_view name, const auto& value, int, int, bool is_signed) {
    if (name == "tag.slot" || name == "ctx" || name == "hit.tag.slot") return;
    if constexpr (requires { static_cast<std::uint64_t>(value); })
      list.push_back({std::string(name), is_signed ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(static_cast<std::uint64_t>(value))});
  });
  return list;
}

class Sheet {
 public:
  explicit Sheet(int limit) : limit_(limit) {}

  // The items of one stage in both; true if they are the same.
  template <class Record> void stage(const char* name, const std::vector<Record>& model, const std::vector<Record>& rtl) {
    const std::size_t count = std::max(model.size(), rtl.size());
    if (count == 0) return;
    std::printf("%s%s\n", name, model.size() == rtl.size() ? "" : "   (not as many in the model as in the RTL)");
    for (std::size_t i = 0; i < count; ++i) {
      const bool shown = i < static_cast<std::size_t>(limit_);
      const auto left = i < model.size() ? fields(model[i]) : std::vector<Field>{};
      const auto right = i < rtl.size() ? fields(rtl[i]) : std::vector<Field>{};
      for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k) {
        const std::string& key = k < left.size() ? left[k].name : right[k].name;
        const std::string a = k < left.size() ? left[k].value : "-", b = k < right.size() ? right[k].value : "-";
        differ_ += a != b;
        if (shown || a != b) std::printf("  %-18s %24s %24s%s\n", key.c_str(), a.c_str(), b.c_str(), a == b ? "" : "   <-- differs");
      }
      if (shown && i + 1 < count) std::printf("\n");
    }
    if (count > static_cast<std::size_t>(limit_)) std::printf("  ... %zu in all\n", count);
  }
  std::size_t differ() const { return differ_; }

 private:
  int limit_;
  std::size_t differ_ = 0;
};

// The hit record as the buffer of either device holds it.
std::vector<hit_record_t> record_at(const sim::Rendering& rendering, int x, int y) { return {rendering.hit(rendering.index(x, y))}; }

ExitCode ray(const Arguments& args) {
  const Scene scene = args.scene.load();
  if (args.x < 0 || args.x >= scene.width || args.y < 0 || args.y >= scene.height)
    throw InputError("pixel (" + std::to_string(args.x) + ", " + std::to_string(args.y) + ") is outside the frame of " +
                     std::to_string(scene.width) + "x" + std::to_string(scene.height));
  const SceneImage image = compile(scene, scene.width, scene.height);
  const sim::RenderOptions options{true, false, sim::PixelWindow{args.x, args.y, args.x + 1, args.y + 1}};

  sim::ModelDevice model;
  sim::Driver model_driver(model);
  model_driver.load(image);
  const sim::Rendering expected = model_driver.render(options);
  if (expected.error != ErrNone) {
    std::fprintf(stderr, "castray: the model refuses the job: %s\n", sim::error_text(expected.error));
    return kDeviceError;
  }
  const RayTrace trace = trace_pixel(model.job(), model.windows(model.job()), args.x, args.y);

  sim::RtlOptions device = args.core.options();
  device.trace_file = args.trace;
  sim::RtlDevice rtl(device);
  sim::Driver rtl_driver(rtl);
  rtl_driver.load(image);
  sim::Probe probe;
  const sim::Probe::Attached attached(probe);
  const sim::Rendering rendering = rtl_driver.render(options);

  std::printf("%s, pixel (%d, %d) of %dx%d: %s\n\n  %-18s %24s %24s\n", args.scene.file.c_str(), args.x, args.y, scene.width,
              scene.height, rtl.description().c_str(), "", "model", "rtl");
  Sheet sheet(args.limit);
  pixel_dir_t direction;
  direction.tag = trace.tag;
  direction.dir = trace.dir;
  sheet.stage("direction (ray_gen)", std::vector{direction}, probe.directions);
  sheet.stage("ray (ray_setup)", std::vector{trace.ray}, probe.rays);
  sheet.stage("accepted primitives (ray_prim)", trace.candidates, probe.candidates);
  sheet.stage("distances (hit_unit)", trace.results, probe.results);
  sheet.stage("nearest hit (lane)", std::vector{trace.hit}, probe.hits);
  sheet.stage("pixel (shade)", std::vector{trace.shaded}, probe.shaded);
  sheet.stage("hit record", record_at(expected, args.x, args.y), record_at(rendering, args.x, args.y));

  const ReferencePixel reference = trace_float64(scene, scene.width, scene.height, args.x, args.y);
  std::printf("\nfloat64: primitive %d, distance %.9g (model %.9g), u %.9g, v %.9g, colour %d %d %d\n", reference.prim, reference.t,
              trace.hit.found ? scene_distance(image, args.x, args.y, trace.hit.t) : std::numeric_limits<double>::infinity(),
              reference.u, reference.v, reference.colour[0], reference.colour[1], reference.colour[2]);
  if (rendering.error != ErrNone) {
    std::fprintf(stderr, "castray: the core stopped: %s\n", sim::error_text(rendering.error));
    return kDeviceError;
  }
  std::printf("%zu values differ between model and RTL\n", sheet.differ());
  return sheet.differ() > 0 ? kMismatch : kOk;
}

}  // namespace

void add_ray(CLI::App& app, int& code) {
  CLI::App* command = app.add_subcommand("ray", "one ray stage by stage, the model beside the RTL");
  const auto args = std::make_shared<Arguments>();
  args->scene.add_to(*command);
  command->add_option("x", args->x, "column of the pixel, from the left")->required();
  command->add_option("y", args->y, "row of the pixel, from the top")->required();
  args->core.add_to(*command);
  command->add_option("--trace", args->trace, "waveforms (FST) of the run");
  command->add_option("--limit", args->limit, "items of a stage that are shown in full")->capture_default_str();
  command->callback([args, &code] { code = ray(*args); });
}

}  // namespace castray::cli
