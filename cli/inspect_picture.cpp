// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/inspect.h"
#include "openltc/base/quote.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace openltc::cli {

namespace {

struct ChannelRange {
  double min = 0, mean = 0, max = 0; // of the finite values, 0 where there are none
};

ChannelRange range_of(const image::Image& image, int channel) {
  ChannelRange range;
  std::size_t count = 0;
  for (std::size_t i = std::size_t(channel); i < image.data.size();
       i += std::size_t(image.channels)) {
    const double value = double(image.data[i]);
    if (!std::isfinite(value)) continue;
    range.min = count == 0 ? value : std::min(range.min, value);
    range.max = count == 0 ? value : std::max(range.max, value);
    range.mean += value;
    ++count;
  }
  if (count > 0) range.mean /= double(count);
  return range;
}

std::size_t count_non_finite_pixels(const image::Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* p = image.pixel(x, y);
      count += !std::all_of(p, p + image.channels, [](float v) { return std::isfinite(v); });
    }
  return count;
}

void describe_layer(const std::string& name, const image::Image& image, Description& out) {
  static const char* const colors[] = {"R", "G", "B", "A"};
  nlohmann::ordered_json layer = {{"name", name}, {"channels", nlohmann::ordered_json::object()}};
  if (!name.empty()) out.text += fmt::format("layer      {}\n", quote(name));
  for (int c = 0; c < image.channels; ++c) {
    const char* channel = image.channels == 1 ? "Y" : colors[c];
    const ChannelRange range = range_of(image, c);
    out.text += fmt::format("{:<10} {:.6g} to {:.6g}, mean {:.6g}\n", channel, range.min, range.max,
                            range.mean);
    layer["channels"][channel] = {{"min", range.min}, {"mean", range.mean}, {"max", range.max}};
  }
  const std::size_t bad = count_non_finite_pixels(image);
  layer["non_finite_pixels"] = bad;
  if (bad > 0)
    out.text += fmt::format("not finite {} of {} pixels have NaN or infinity; not in the numbers\n",
                            bad, image.pixel_count());
  out.json["layers"].push_back(layer);
}

} // namespace

Result<Description> inspect_picture(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  std::vector<std::string> names = {""};
  if (extension == ".exr") {
    Result<std::vector<std::string>> found = image::layer_names(path);
    if (!found) return found.error();
    names = *found;
    if (names.empty())
      return Error{fmt::format("{}: holds no channels that make a picture (R, G, B or Y)", path)};
  }

  Description out;
  const bool is_linear = image::is_scene_linear_extension(path);
  for (const std::string& name : names) {
    const Result<image::Image> image =
        extension == ".exr" ? image::read_layer(path, name) : image::read(path);
    if (!image) return image.error();
    if (out.json.is_null()) {
      out.text = fmt::format("picture, {}x{} pixels, {}\n", image->width, image->height,
                             is_linear ? "scene-linear" : "sRGB; the numbers are linear light");
      out.json = {{"file", path},
                  {"kind", "picture"},
                  {"width", image->width},
                  {"height", image->height},
                  {"encoding", is_linear ? "linear" : "srgb"},
                  {"layers", nlohmann::ordered_json::array()}};
    }
    describe_layer(name, *image, out);
    if (is_linear && name.empty()) {
      const float ev100 = image::ev100_from_exposure(image::auto_exposure(*image));
      out.text += fmt::format("exposure   EV100 {:.2f}, if values are in nits\n", ev100);
      out.json["ev100"] = ev100;
    }
  }
  return out;
}

} // namespace openltc::cli
