// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/inspect/inspect.h"
#include "openltc/base/quote.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace openltc::cli {

namespace {

bool has_layers(const std::string& path) {
  return path.size() > 4 && std::equal(path.end() - 4, path.end(), ".exr", [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

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

std::vector<const char*> short_names(const image::LayerInfo& info, int channels) {
  if (info.kind == image::LayerKind::vector) return {"X", "Y", "Z"};
  if (channels == 1) return {"Y"};
  return {"R", "G", "B", "A"}; // also of what becomes RGB in reading
}

nlohmann::ordered_json as_json(const image::Window& window) {
  return {{"x", window.x}, {"y", window.y}, {"width", window.width}, {"height", window.height}};
}

// What the layer is, where that is more than a plain picture.
void describe_kind(const image::LayerInfo& info, Description& out, nlohmann::ordered_json& layer) {
  std::string text = image::name_of(info.kind);
  if (!info.part_name.empty())
    text += fmt::format(", part {} '{}'", info.part, quote(info.part_name));
  if (info.other_primaries) text += ", converted to Rec.709";
  const bool plain =
      info.kind == image::LayerKind::color && info.name.empty() && !info.other_primaries;
  if (!plain)
    out.text +=
        fmt::format("layer      {}{}{}\n", quote(info.name), info.name.empty() ? "" : ": ", text);
  if (!(info.data == info.display))
    out.text += fmt::format("data       {}; the picture is {}, the rest of it 0\n",
                            image::describe(info.data), image::describe(info.display));
  if (info.pixel_aspect != 1.0)
    out.text += fmt::format("pixels     {:.5g} times as wide as high\n", info.pixel_aspect);
  layer["kind"] = image::name_of(info.kind);
  layer["file_channels"] = info.channels;
  layer["part"] = info.part;
  if (!info.part_name.empty()) layer["part_name"] = info.part_name;
  layer["converted_to_rec709"] = info.other_primaries;
  layer["display_window"] = as_json(info.display);
  layer["data_window"] = as_json(info.data);
  layer["pixel_aspect"] = info.pixel_aspect;
}

void describe_layer(const image::LayerInfo& info, const Result<image::Image>& image,
                    Description& out) {
  nlohmann::ordered_json layer = {{"name", info.name}};
  describe_kind(info, out, layer);
  if (!image) {
    out.text += fmt::format("not read   {}\n", image.error().message);
    layer["error"] = image.error().message;
    out.json["layers"].push_back(layer);
    return;
  }
  const std::vector<const char*> names = short_names(info, image->channels);
  layer["channels"] = nlohmann::ordered_json::object();
  for (int c = 0; c < image->channels; ++c) {
    const char* channel = names[std::size_t(c)];
    const ChannelRange range = range_of(*image, c);
    out.text += fmt::format("{:<10} {:.6g} to {:.6g}, mean {:.6g}\n", channel, range.min, range.max,
                            range.mean);
    layer["channels"][channel] = {{"min", range.min}, {"mean", range.mean}, {"max", range.max}};
  }
  const std::size_t bad = count_non_finite_pixels(*image);
  layer["non_finite_pixels"] = bad;
  if (bad > 0)
    out.text += fmt::format("not finite {} of {} pixels have NaN or infinity; not in the numbers\n",
                            bad, image->pixel_count());
  out.json["layers"].push_back(layer);
}

// The layers to describe: that of this name, or all.
Result<std::vector<image::LayerInfo>> wanted_layers(const std::string& path,
                                                    const std::string& wanted) {
  Result<std::vector<image::LayerInfo>> layers = image::list_layers(path);
  if (!layers) return layers;
  if (layers->empty()) return Error{fmt::format("{}: holds no channels", path)};
  if (wanted.empty()) return layers;
  const Result<image::LayerInfo> chosen = image::choose_layer(*layers, wanted, path);
  if (!chosen) return chosen.error();
  return std::vector<image::LayerInfo>{*chosen};
}

} // namespace

Result<Description> inspect_picture(const std::string& path, const std::string& wanted) {
  const bool is_exr = has_layers(path);
  std::vector<image::LayerInfo> layers;
  std::optional<image::Image> whole; // of a file without layers
  if (is_exr) {
    Result<std::vector<image::LayerInfo>> found = wanted_layers(path, wanted);
    if (!found) return found.error();
    layers = std::move(*found);
  } else {
    Result<image::Picture> picture = image::read_picture(path, wanted);
    if (!picture) return picture.error();
    layers.push_back(picture->layer);
    whole = std::move(picture->image);
  }

  Description out;
  const bool is_linear = image::is_scene_linear_extension(path);
  out.text =
      fmt::format("picture, {}x{} pixels, {}\n", layers[0].display.width, layers[0].display.height,
                  is_linear ? "scene-linear" : "sRGB; the numbers are linear light");
  out.json = {{"file", path},
              {"kind", "picture"},
              {"width", layers[0].display.width},
              {"height", layers[0].display.height},
              {"encoding", is_linear ? "linear" : "srgb"},
              {"layers", nlohmann::ordered_json::array()}};
  // The layer that is taken when nobody names one.
  const Result<image::LayerInfo> picture = image::choose_layer(layers, "", path);
  if (is_exr && wanted.empty())
    out.json["picture"] = picture ? nlohmann::ordered_json(picture->name) : nullptr;
  if (is_exr && wanted.empty() && !(picture && picture->name.empty()))
    out.text += picture ? fmt::format("picture    {}, which is taken when no layer is named\n",
                                      picture->name)
                        : std::string("picture    none that is taken when no layer is named\n");
  std::optional<Error> first_error;
  bool any = false;
  for (const image::LayerInfo& layer : layers) {
    const Result<image::Image> image =
        whole ? Result<image::Image>(std::move(*whole)) : image::read_layer(path, layer.name);
    if (!image && !first_error) first_error = image.error();
    any = any || image.ok();
    describe_layer(layer, image, out);
    if (image && is_linear && picture && picture->name == layer.name) {
      const float ev100 = image::ev100_from_exposure(image::auto_exposure(*image));
      out.text += fmt::format("exposure   EV100 {:.2f}, if values are in nits\n", ev100);
      out.json["ev100"] = ev100;
    }
  }
  if (!any) return *first_error;
  return out;
}

} // namespace openltc::cli
