// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/convert/picture.h"

#include "cli/output_place.h"
#include "cli/process/message.h"
#include "openltc/image/display.h"
#include "openltc/table/packed_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace openltc::cli {

namespace {

bool ends_with(const std::string& path, std::string_view ending) {
  return path.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

std::optional<float> parse_ev100(const std::string& text) {
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::fabs(value) <= 60.0f ? std::optional(value) : std::nullopt;
}

// Multiplies colours by alpha, or divides them by it.
void change_alpha(image::Image& image, bool premultiply) {
  if (image.channels != 4) return;
  for (std::size_t i = 0; i < image.data.size(); i += 4) {
    const float alpha = image.data[i + 3];
    const float factor = premultiply ? alpha : alpha > 0.0f ? 1.0f / alpha : 1.0f;
    if (!std::isfinite(factor)) continue;
    for (std::size_t c = 0; c < 3; ++c)
      image.data[i + c] *= factor;
  }
}

} // namespace

std::string check_exposure(const std::string& text) {
  if (text == "auto" || parse_ev100(text)) return "";
  return "must be 'auto' or an EV100 from -60 to 60, not '" + text + "'";
}

bool is_picture_file(const std::string& input, const std::string& output) {
  const image::PictureName name = image::split_picture_name(input);
  if (!image::is_readable_extension(name.path)) return false;
  if (!ends_with(name.path, ".exr") || !name.layer.empty()) return true;
  if (!ends_with(output, ".exr")) return image::is_writable_extension(output);
  // From .exr to .exr, by the rule of openltc inspect.
  const Result<table::TextureFiles> files = table::read_textures(name.path);
  return !files || (files->description.empty() && files->textures.size() < 2);
}

Status convert_picture(const std::string& input, const std::string& output,
                       const PictureConversion& options, bool quiet) {
  if (!image::is_writable_extension(output))
    return Error{fmt::format("{}: a picture is written as .exr, .hdr or .png", output)};
  image::PictureName name = image::split_picture_name(input);
  if (!options.layer.empty()) name.layer = options.layer;
  if (Status ok = check_place(output); !ok) return ok;
  Result<image::Picture> picture = image::read_picture(name.path, name.layer);
  if (!picture) return picture.error();
  if (Status ok = check_not_read({output}); !ok) return ok;
  if (picture->layer.kind == image::LayerKind::vector)
    return Error{fmt::format("{}: the layer '{}' is a vector, no colours; only pictures and single "
                             "channels are converted",
                             name.path, picture->layer.name)};

  image::Image image = std::move(picture->image);
  const bool from_linear = image::is_scene_linear_extension(name.path);
  const bool to_linear = image::is_scene_linear_extension(output);
  const bool from_exr = ends_with(name.path, ".exr"), to_png = ends_with(output, ".png");
  if (from_exr && to_png) change_alpha(image, false);
  if (!from_exr && !to_png) change_alpha(image, true);
  image::DisplayOptions display;
  if (from_linear && !to_linear) {
    if (options.exposure && *options.exposure != "auto")
      display.ev100 = parse_ev100(*options.exposure);
    display.tonemap = options.tonemap.value_or(image::Tonemap::neutral);
  } else if (options.exposure || options.tonemap) {
    return Error{fmt::format("{}: --exposure and --tonemap are for a .png from .exr or .hdr; here "
                             "the values stay as they are",
                             output)};
  }
  float exposure = 1.0f;
  if (from_linear && !to_linear) {
    const Result<float> resolved = image::resolve_exposure(image, display);
    if (!resolved) return resolved.error();
    exposure = *resolved;
  } else {
    display.tonemap = image::Tonemap::none;
  }
  if (Status ok = image::write_picture(output, image, nullptr, exposure, display.tonemap,
                                       options.precision);
      !ok)
    return ok;
  if (quiet) return Success{};
  const std::string layer =
      picture->layer.name.empty() ? "" : fmt::format(", the layer {}", picture->layer.name);
  const std::string shown =
      from_linear && !to_linear
          ? fmt::format(", at EV100 {:.2f}", image::ev100_from_exposure(exposure))
          : "";
  say("wrote {}{}{}\n", output, layer, shown);
  return Success{};
}

} // namespace openltc::cli
