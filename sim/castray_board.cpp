// SPDX-License-Identifier: Apache-2.0
// A compiled scene image to a picture, or a list of rays to its hits, on the board or by the model. A program of the
// standard library alone: cross-compiled, it needs nothing on the board (docs/uio.md).
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>

#include "cli/exit_code.hpp"
#include "driver.hpp"
#include "model_device.hpp"
#include "scene/files.hpp"
#include "scene/replacement.hpp"
#include "scene/scene_error.hpp"
#include "uio/open_board.hpp"

namespace castray::sim {
namespace {

constexpr const char* kUsage =
    "usage: castray_board IMAGE [--engine uio|model] [--mode bvh|bvh_root|brute] [-o PICTURE.ppm] [--frame FILE] [--hits FILE]\n"
    "                     [--rays FILE] [--uio NAME|/dev/uioN] [--udmabuf NAME | --reserved ADDRESS:BYTES]\n"
    "                     [--timeout MILLISECONDS] [--poll yes|no]\n"
    "IMAGE: of 'castray compile'. --rays: 64-byte records instead of a frame; their hit records go to --hits.\n";

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Arguments {
  std::string image;
  std::map<std::string, std::string> options{{"--engine", "uio"}, {"--mode", "bvh"},      {"-o", ""},           {"--frame", ""},
                                             {"--hits", ""},      {"--rays", ""},         {"--uio", "castray"}, {"--udmabuf", ""},
                                             {"--reserved", ""},  {"--timeout", "10000"}, {"--poll", "no"}};

  Arguments(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word[0] != '-' && image.empty()) {
        image = word;
      } else if (const auto option = options.find(word); option != options.end() && i + 1 < argc) {
        option->second = argv[++i];
        if (option->second.empty() && (word == "-o" || word == "--frame" || word == "--hits" || word == "--rays"))
          throw UsageError(word + ": the name is empty");
      } else {
        throw UsageError(word + ": is no option, or its value is missing");
      }
    }
    if (image.empty()) throw UsageError("no scene image is named");
    if (at("--engine") != "uio" && at("--engine") != "model") throw UsageError("--engine " + at("--engine") + ": uio or model");
    if (at("--poll") != "yes" && at("--poll") != "no") throw UsageError("--poll " + at("--poll") + ": yes or no");
    if (at("--timeout").empty() || at("--timeout").find_first_not_of("0123456789") != std::string::npos ||
        at("--timeout").size() > 9)
      throw UsageError("--timeout " + at("--timeout") + ": milliseconds");
    if (!at("--rays").empty() && at("--hits").empty()) throw UsageError("--rays: its hit records need --hits FILE");
    if (!at("--rays").empty() && (!at("-o").empty() || !at("--frame").empty()))
      throw UsageError("-o, --frame: a list of rays has no picture; its hit records go to --hits");
  }
  // Before the job: each output can be written, and is no file that another option names.
  void check_outputs() const {
    std::map<std::filesystem::path, std::string> taken{{place_of(image), "the scene image"}};
    if (!at("--rays").empty()) taken.emplace(place_of(at("--rays")), "the file of --rays");
    for (const char* const option : {"-o", "--frame", "--hits"}) {
      const std::string& file = at(option);
      if (file.empty()) continue;
      std::error_code error;
      const auto status = std::filesystem::status(file, error);
      if (std::filesystem::is_regular_file(status) || !std::filesystem::exists(status))
        if (const auto [other, is_new] = taken.emplace(place_of(file), std::string("the file of ") + option); !is_new)
          throw UsageError(std::string(option) + " " + file + ": is " + other->second + " as well");
      if (const std::error_code unwritable = Replacement::check(file)) throw OutputError(file + ": cannot be written: " + unwritable.message());
    }
  }
  const std::string& at(const std::string& name) const { return options.at(name); }

  Mode mode() const {
    for (std::size_t i = 0; i < kModeNames.size(); ++i)
      if (at("--mode") == kModeNames[i]) return static_cast<Mode>(i);
    throw UsageError("--mode " + at("--mode") + ": bvh, bvh_root or brute");
  }
  BoardOptions board() const {
    return {.uio = at("--uio"), .udmabuf = at("--udmabuf"), .reserved = at("--reserved"),
            .patience = {std::chrono::milliseconds(std::stoi(at("--timeout"))), at("--poll") == "yes"}, .roots = {}};
  }
};

// The portable pixmap: colours alone, row by row.
std::string pixmap(const Rendering& rendering, bool bgra) {
  std::string text = "P6\n" + std::to_string(rendering.width) + " " + std::to_string(rendering.height) + "\n255\n";
  for (const std::uint32_t word : rendering.pixels)
    for (const int shift : {bgra ? 16 : 0, 8, bgra ? 0 : 16}) text += static_cast<char>(word >> shift);
  return text;
}

void write_output(const std::string& file, const std::string& bytes) {
  try {
    write_file(file, bytes);
  } catch (const SceneError& e) {
    throw OutputError(e.what());
  }
}
template <class Words> void write_words(const std::string& file, const Words& words) {
  if (!file.empty()) write_output(file, std::string(reinterpret_cast<const char*>(words.data()), words.size() * sizeof words[0]));
}

error_t run(const Arguments& args) {
  const Mode mode = args.mode();
  args.check_outputs();
  const SceneImage image = read_image(args.image);
  const std::string rays = args.at("--rays").empty() ? "" : read_file(args.at("--rays"), std::uint64_t{MaxRays} * RayBytes);
  if (args.at("--rays").empty() && image.frame.width == 0)
    throw UsageError(args.image + ": is compiled for a list of rays: name one with --rays");
  std::unique_ptr<Device> device;
  if (args.at("--engine") == "uio") device = open_board(args.board());
  else device = std::make_unique<ModelDevice>();
  Driver driver(*device);
  driver.load(image);
  const auto start = std::chrono::steady_clock::now();
  const auto report = [&](const auto& result, const std::string& what) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%s, %s: %s\n  rays %llu, hits %llu; cycles %llu; %.4f s\n", args.image.c_str(), what.c_str(),
                device->description().c_str(), static_cast<unsigned long long>(result.counters[CntRays]),
                static_cast<unsigned long long>(result.counters[CntHits]), static_cast<unsigned long long>(result.cycles()),
                seconds);
    if (result.error == ErrNone) write_words(args.at("--hits"), result.hits);
    return result.error;
  };
  if (!args.at("--rays").empty()) {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(rays.data()), rays.size());
    return report(driver.query(bytes, {.mode = mode}), std::to_string(rays.size() / RayBytes) + " rays");
  }
  const Rendering rendering = driver.render({.mode = mode});
  const error_t error = report(rendering, std::to_string(rendering.width) + "x" + std::to_string(rendering.height));
  if (error != ErrNone) return error;
  write_words(args.at("--frame"), rendering.pixels);
  if (!args.at("-o").empty())
    write_output(args.at("-o"), pixmap(rendering, image.frame.pixel_format == static_cast<std::uint64_t>(PixelBgra8)));
  return ErrNone;
}

int complain(cli::ExitCode code, const char* what) {
  std::fprintf(stderr, "castray_board: %s\n", what);
  return code;
}

// The exit codes are those of castray.
int program(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--help") == 0) return std::printf("%s", kUsage), 0;
  try {
    const error_t error = run(Arguments(argc, argv));
    if (error == ErrNone && (std::fflush(stdout) != 0 || std::ferror(stdout))) return complain(cli::kBadOutput, "standard output cannot be written");
    return error == ErrNone ? 0 : complain(cli::kDeviceError, (std::string("the core stopped: ") + meaning(error)).c_str());
  } catch (const UsageError& e) {
    return complain(cli::kBadInput, e.what());
  } catch (const OutputError& e) {
    return complain(cli::kBadOutput, e.what());
  } catch (const SceneError& e) {
    return complain(cli::kBadInput, e.what());
  } catch (const std::invalid_argument& e) {
    return complain(cli::kBadInput, e.what());
  } catch (const DeviceError& e) {
    return complain(cli::kHang, e.what());
  } catch (const std::exception& e) {
    return complain(cli::kInternal, e.what());
  }
}

}  // namespace
}  // namespace castray::sim

int main(int argc, char** argv) { return castray::sim::program(argc, argv); }
