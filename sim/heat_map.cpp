// SPDX-License-Identifier: Apache-2.0
#include "heat_map.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace castray::sim {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;
using OIIO::TypeDesc;
namespace Algo = OIIO::ImageBufAlgo;

constexpr int kLeastWidth = 320;   // of the picture
constexpr int kMostEnlarged = 4096;   // rows of a frame that is enlarged: a narrow one may be high
constexpr int kBarHeight = 12, kTextHeight = 13, kMargin = 4;
constexpr int kFooter = kBarHeight + kTextHeight + 4 * kMargin;
constexpr const char* kFont = "DejaVuSans";   // package fonts-dejavu-core

// Colours of values between 0 and 1, value(x, y).
template <class Value> ImageBuf colours(int width, int height, Value&& value) {
  ImageBuf values(ImageSpec(width, height, 1, TypeDesc::FLOAT));
  for (ImageBuf::Iterator<float> at(values); !at.done(); ++at) at[0] = value(at.x(), at.y());
  return Algo::color_map(values, 0, "inferno");
}

std::string mean_of(std::span<const std::uint32_t> values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", sum / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
  return text;
}

// Pixels of the sheet for each of the frame, either way.
int scale_of(int width, int height) { return std::max(1, std::min((kLeastWidth + width - 1) / width, kMostEnlarged / height)); }
int across_of(int width, int height) { return std::max(kLeastWidth, width * scale_of(width, height)); }  // room for the scale

}  // namespace

void check_heat_map(const std::filesystem::path& file, int width, int height) {
  check_picture(file, across_of(width, height), height * scale_of(width, height) + kFooter);
}

void write_heat_map(const std::filesystem::path& file, int width, int height, std::span<const std::uint32_t> values,
                    const std::string& caption, const Metadata& metadata) {
  const int scale = scale_of(width, height), down = height * scale, across = across_of(width, height);
  const std::uint32_t most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  const auto at = [&](int x, int y) {
    const std::size_t pixel = static_cast<std::size_t>(y / scale) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x / scale);
    return static_cast<float>(values[pixel]) / static_cast<float>(std::max(most, 1u));
  };
  ImageBuf sheet(ImageSpec(across, down + kFooter, 3, TypeDesc::FLOAT));
  Algo::zero(sheet);
  Algo::paste(sheet, (across - width * scale) / 2, 0, 0, 0, colours(width * scale, down, at));
  const int bar = across - 2 * kMargin;
  Algo::paste(sheet, kMargin, down + kMargin, 0, 0,
              colours(bar, kBarHeight, [&](int x, int) { return static_cast<float>(x) / static_cast<float>(bar - 1); }));
  const float white[] = {1, 1, 1};
  const auto text = [&](int x, const std::string& words, Algo::TextAlignX align) {
    return Algo::render_text(sheet, x, down + kBarHeight + 2 * kMargin + kTextHeight, words, kTextHeight, kFont, white, align,
                              Algo::TextAlignY::Baseline);
  };
  if (!text(kMargin, "0", Algo::TextAlignX::Left) ||
      !text(across / 2, caption + ", mean " + mean_of(values), Algo::TextAlignX::Center) ||
      !text(across - kMargin, std::to_string(most), Algo::TextAlignX::Right))
    throw PictureError(file, "its scale cannot be written: " + sheet.geterror());
  Picture picture{across, down + kFooter, {}};
  picture.rgb.resize(static_cast<std::size_t>(across) * static_cast<std::size_t>(down + kFooter) * 3);
  sheet.get_pixels(sheet.roi(), TypeDesc::UINT8, picture.rgb.data());
  write_picture(file, picture, metadata);
}

}  // namespace castray::sim
