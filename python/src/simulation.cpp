// SPDX-License-Identifier: Apache-2.0
// The simulated core and the compiler of scenes for Python: registers, memory, cycles, and nothing that a
// board would not have. What drives it is python/castray/core.py.
#include <dlfcn.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <map>
#include <optional>

#include "rtl_device.hpp"
#include "scene/compile.hpp"
#include "scene/load.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace castray::python {
namespace {

using BytesIn = nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using BytesOut = nb::ndarray<std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Vectors = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

class Core {
 public:
  Core(const std::string& cores, int lanes, int contexts, int tile_log2, int ports, int l2_kbytes, const std::string& memory,
       const std::string& stalls, std::uint64_t seed)
      : device_(options(cores, {lanes, contexts, tile_log2, ports, l2_kbytes}, memory, stalls, seed)) {}

  std::string description() const { return device_.description(); }
  std::uint32_t read32(unsigned offset) { return device_.read_reg(offset); }
  void write32(unsigned offset, std::uint32_t value) {
    device_.write_reg(offset, value);
    started_ = device_.memory().cycle();
  }
  std::uint64_t allocate(std::uint64_t bytes) {
    const sim::Buffer buffer = device_.allocate(bytes);
    return buffers_.emplace(buffer.address, buffer).first->first;
  }
  void release(std::uint64_t address) {
    const auto found = buffers_.find(address);
    if (found == buffers_.end()) return;
    device_.release(found->second);
    buffers_.erase(found);
  }
  void write(std::uint64_t address, const BytesIn& bytes) { device_.write(address, {bytes.data(), bytes.size()}); }
  void read(std::uint64_t address, const BytesOut& bytes) { device_.read(address, {bytes.data(), bytes.size()}); }
  // True as soon as the interrupt is high.
  bool run(std::uint64_t cycles) { return device_.advance(cycles); }
  // Cycles since a register was written, or anything passed on the bus.
  std::uint64_t quiet() { return device_.memory().cycle() - std::max(started_, device_.memory().last_activity()); }
  void reset() { device_.reset(); }
  std::vector<std::string> violations() { return device_.memory().messages(); }

 private:
  static sim::RtlOptions options(const std::string& cores, const sim::CoreVariant& variant, const std::string& memory,
                                 const std::string& stalls, std::uint64_t seed) {
    sim::RtlOptions options;
    options.cores = cores;
    options.variant = variant;
    options.timing = sim::AxiTiming::named(memory);
    options.stalls = stalls;
    options.seed = seed;
    return options;
  }

  sim::RtlDevice device_;
  std::map<std::uint64_t, sim::Buffer> buffers_;
  std::uint64_t started_ = 0;
};

nb::tuple compile_scene(const std::string& file, std::optional<std::pair<int, int>> size, std::optional<Vectors> origins) {
  const auto frame = size ? std::optional(FrameSize{size->first, size->second}) : std::nullopt;
  const Scene scene = load_scene(file, frame);
  SceneImage image;
  if (origins) {
    std::vector<ListRay> rays(origins->shape(0));
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].origin = Vec3((*origins)(i, 0), (*origins)(i, 1), (*origins)(i, 2));
    image = compile(scene, rays);
  } else {
    image = compile(scene, scene.width, scene.height);
  }
  std::vector<std::string> warnings = scene.warnings;
  warnings.insert(warnings.end(), image.warnings.begin(), image.warnings.end());
  return nb::make_tuple(nb::bytes(image.bytes.data(), image.bytes.size()), warnings);
}

// A core's shared object takes the memory model and the probe from the program that loads it: here, from this library.
void offer_symbols() {
  Dl_info self;
  if (!dladdr(reinterpret_cast<void*>(&offer_symbols), &self) || !dlopen(self.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL))
    throw std::runtime_error(std::string("castray's library does not find itself: ") + dlerror());
}

}  // namespace

NB_MODULE(_simulation, m) {
  offer_symbols();
  nb::exception<SceneError>(m, "SceneError", PyExc_ValueError);
  nb::class_<Core>(m, "Core")
      .def(nb::init<const std::string&, int, int, int, int, int, const std::string&, const std::string&, std::uint64_t>())
      .def_prop_ro("description", &Core::description)
      .def("read32", &Core::read32)
      .def("write32", &Core::write32)
      .def("allocate", &Core::allocate)
      .def("release", &Core::release)
      .def("write", &Core::write)
      .def("read", &Core::read)
      .def("run", &Core::run, nb::call_guard<nb::gil_scoped_release>())
      .def_prop_ro("quiet", &Core::quiet)
      .def("reset", &Core::reset)
      .def("violations", &Core::violations);
  m.def("compile", &compile_scene, "file"_a, "size"_a = nb::none(), "origins"_a = nb::none());
}

}  // namespace castray::python
