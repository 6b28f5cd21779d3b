// SPDX-License-Identifier: Apache-2.0
// castray compare: two pictures, their dimensions first.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "command.hpp"
#include "picture.hpp"

namespace castray::cli {
namespace {

struct Arguments {
  std::string a;
  std::string b;
  int tolerance = 0;
};

// The libraries of some formats write to standard error themselves, before the error arrives here: while this stands they
// write to nobody.
class Silence {
 public:
  Silence() : kept_(dup(STDERR_FILENO)), nobody_(open("/dev/null", O_WRONLY | O_CLOEXEC)) {
    std::fflush(stderr);
    if (kept_ >= 0 && nobody_ >= 0) dup2(nobody_, STDERR_FILENO);
  }
  ~Silence() {
    std::fflush(stderr);
    if (kept_ >= 0 && nobody_ >= 0) dup2(kept_, STDERR_FILENO);
    if (kept_ >= 0) close(kept_);
    if (nobody_ >= 0) close(nobody_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int kept_, nobody_;
};

sim::Picture read(const std::string& file) {
  try {
    const Silence silence;
    return sim::read_picture(file);
  } catch (const sim::PictureError& e) {
    throw InputError(e.what());
  }
}

ExitCode compare(const Arguments& args) {
  const sim::Picture a = read(args.a), b = read(args.b);
  if (a.width != b.width || a.height != b.height) {
    std::printf("%s is %dx%d, %s is %dx%d\n", args.a.c_str(), a.width, a.height, args.b.c_str(), b.width, b.height);
    return kMismatch;
  }
  std::size_t differ = 0, first = 0;
  int worst = 0;
  for (std::size_t pixel = 0; pixel < a.rgb.size() / 3; ++pixel) {
    int distance = 0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) distance = std::max(distance, std::abs(a.rgb[i] - b.rgb[i]));
    worst = std::max(worst, distance);
    if (distance <= args.tolerance) continue;
    if (differ++ == 0) first = pixel;
  }
  const auto width = static_cast<std::size_t>(a.width);
  std::printf("%zu of %zu pixels differ by more than %d of 255, the worst by %d\n", differ, a.rgb.size() / 3, args.tolerance, worst);
  if (differ > 0) std::printf("the first at (%zu, %zu)\n", first % width, first / width);
  return differ > 0 ? kMismatch : kOk;
}

}  // namespace

void add_compare(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("compare", "compare two pictures of the same size");
  const auto args = std::make_shared<Arguments>();
  command->add_option("a", args->a, "a picture")->required();
  command->add_option("b", args->b, "another")->required();
  command->add_option("--tolerance", args->tolerance, "how far a channel may be away, of 255")->check(CLI::Range(0, 255))->capture_default_str();
  command->callback([args, &context] { context.code = compare(*args); });
}

}  // namespace castray::cli
