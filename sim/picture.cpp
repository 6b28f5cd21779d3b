// SPDX-License-Identifier: Apache-2.0
#include "picture.hpp"

#include <OpenImageIO/imageio.h>

#include <limits>
#include <memory>
#include <string_view>

#include "scene/compile.hpp"
#include "scene/replacement.hpp"

#include "mem/hit_writer.hpp"

namespace castray::sim {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

// What OpenImageIO says, on one line.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text.empty() ? "unknown cause" : text;
}

std::unique_ptr<OIIO::ImageOutput> output_for(const fs::path& file) {
  auto output = OIIO::ImageOutput::create(file.string());
  if (!output) throw PictureError(file, "no picture format of this name: " + last_line(OIIO::geterror()));
  return output;
}

// To the name, for the file.
void write_to(OIIO::ImageOutput& output, const fs::path& file, const fs::path& name, const ImageSpec& spec, TypeDesc format, const void* data) {
  if (!output.open(name.string(), spec) || !output.write_image(format, data) || !output.close())
    throw PictureError(file, "cannot be written: " + last_line(output.geterror()));
}

void write(const fs::path& file, ImageSpec& spec, TypeDesc format, const void* data, const Metadata& metadata) {
  for (const auto& [key, value] : metadata) spec.attribute(key, value);
  Replacement replacement(file);
  write_to(*output_for(file), file, replacement.name(), spec, format, data);
  if (const std::error_code error = replacement.commit()) throw PictureError(file, "cannot be written: " + error.message());
}

// One pixel of the EXR: its channels one after the other, as OpenImageIO takes mixed formats.
struct AovPixel {
  float t, u, v, prim;
  std::uint32_t hit_t, hit_u, hit_v, hit_prim, hit_instance;
};
static_assert(sizeof(AovPixel) == 9 * 4);

}  // namespace

Picture picture_of(const Rendering& rendering, PixelFormat format) {
  Picture picture{rendering.width, rendering.height, {}};
  const int red = format == PixelFormat::Bgra8 ? 16 : 0;
  for (const std::uint32_t word : rendering.pixels)
    for (const int shift : {red, 8, 16 - red}) picture.rgb.push_back(static_cast<std::uint8_t>(word >> shift));
  return picture;
}

Picture picture_of(const ReferenceFrame& frame) {
  Picture picture{frame.width, frame.height, {}};
  for (const ReferencePixel& pixel : frame.pixels) picture.rgb.insert(picture.rgb.end(), pixel.colour.begin(), pixel.colour.end());
  return picture;
}

void write_picture(const fs::path& file, const Picture& picture, const Metadata& metadata) {
  ImageSpec spec(picture.width, picture.height, 3, TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write(file, spec, TypeDesc::UINT8, picture.rgb.data(), metadata);
}

Picture read_picture(const fs::path& file) {
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input) throw PictureError(file, last_line(OIIO::geterror()));
  const ImageSpec& spec = input->spec();
  if (spec.nchannels < 3) throw PictureError(file, "has fewer than three channels");
  Picture picture{spec.width, spec.height, {}};
  picture.rgb.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * 3);
  if (!input->read_image(0, 0, 0, 3, TypeDesc::UINT8, picture.rgb.data())) throw PictureError(file, last_line(input->geterror()));
  return picture;
}

void write_aov(const fs::path& file, const Rendering& rendering, const SceneImage& image, const Metadata& metadata) {
  ImageSpec spec(rendering.width, rendering.height, 9, TypeDesc::FLOAT);
  spec.channelnames = {"t", "u", "v", "prim", "hit.t", "hit.u", "hit.v", "hit.prim", "hit.instance"};
  spec.channelformats = {TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::UINT32,
                         TypeDesc::UINT32, TypeDesc::UINT32, TypeDesc::UINT32, TypeDesc::UINT32};
  std::vector<AovPixel> pixels;
  for (int y = 0; y < rendering.height; ++y) {
    for (int x = 0; x < rendering.width; ++x) {
      const hit_record_t hit = rendering.hit(rendering.index(x, y));
      const bool found = is_hit(hit);
      AovPixel pixel;
      pixel.t = found ? static_cast<float>(scene_distance(image, x, y, hit.t)) : std::numeric_limits<float>::infinity();
      pixel.u = static_cast<float>(hit.u) / (1 << BaryFrac);
      pixel.v = static_cast<float>(hit.v) / (1 << BaryFrac);
      pixel.prim = found ? static_cast<float>(hit.prim) : -1.0f;
      pixel.hit_t = static_cast<std::uint32_t>(hit.t);
      pixel.hit_u = static_cast<std::uint32_t>(hit.u);
      pixel.hit_v = static_cast<std::uint32_t>(hit.v);
      pixel.hit_prim = static_cast<std::uint32_t>(hit.prim);
      pixel.hit_instance = static_cast<std::uint32_t>(hit.instance_id);
      pixels.push_back(pixel);
    }
  }
  write(file, spec, TypeDesc::UNKNOWN, pixels.data(), metadata);
}

void write_aov(const fs::path& file, const ReferenceFrame& frame, const Metadata& metadata) {
  ImageSpec spec(frame.width, frame.height, 4, TypeDesc::FLOAT);
  spec.channelnames = {"t", "u", "v", "prim"};
  std::vector<float> values;
  for (const ReferencePixel& pixel : frame.pixels) {
    const double row[] = {pixel.t, pixel.u, pixel.v, static_cast<double>(pixel.prim)};
    for (const double value : row) values.push_back(static_cast<float>(value));
  }
  write(file, spec, TypeDesc::FLOAT, values.data(), metadata);
}

void check_writable(const fs::path& file) {
  if (const std::error_code error = Replacement::check(file)) throw PictureError(file, "cannot be written: " + error.message());
}

// Not every format that OpenImageIO writes holds three channels of any size: a black picture is written beside its place, and
// removed. What stands there and is no file, a pipe, is not written twice.
void check_picture(const fs::path& file, int width, int height) {
  const auto output = output_for(file);
  const std::string_view format = output->format_name();
  if (format == "null" || format == "term") throw PictureError(file, "no picture format of this name: it makes no file");
  check_writable(file);
  const Replacement replacement(file);
  if (replacement.name() == file) return;
  write_to(*output, file, replacement.name(), ImageSpec(width, height, 3, TypeDesc::UINT8), TypeDesc::UINT8,
           std::vector<std::uint8_t>(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)).data());
}

void check_aov(const fs::path& file) {
  if (!output_for(file)->supports("channelformats")) throw PictureError(file, "cannot hold channels of several formats; .exr can");
  check_writable(file);
}

}  // namespace castray::sim
