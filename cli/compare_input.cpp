// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/compare_input.h"

#include "cli/process/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace openltc::cli {

namespace {

using image::Window;

// What the file knows of its picture, in pixels of the picture.
Window known_part(const image::LayerInfo& layer) {
  const Window &data = layer.data, &display = layer.display;
  const auto cut = [](std::int64_t begin, std::int64_t size, std::int64_t from,
                      std::int64_t length) {
    const std::int64_t first = std::clamp<std::int64_t>(begin - from, 0, length);
    const std::int64_t end = std::clamp<std::int64_t>(begin + size - from, 0, length);
    return std::pair(int(first), int(end - first));
  };
  const auto [x, width] = cut(data.x, data.width, display.x, display.width);
  const auto [y, height] = cut(data.y, data.height, display.y, display.height);
  return {x, y, width, height};
}

const char* kind_in_words(const image::LayerInfo& layer) {
  if (image::is_picture(layer.kind)) return "a picture";
  return layer.kind == image::LayerKind::vector ? "a vector, no colours" : "a single channel";
}

} // namespace

Result<ComparedPicture> read_compared(const std::string& name, const std::string& layer) {
  image::PictureName parts = image::split_picture_name(name);
  if (parts.layer.empty()) parts.layer = layer;
  Result<image::Picture> picture = image::read_picture(parts.path, parts.layer);
  if (!picture) return picture.error();
  if (picture->layer.kind == image::LayerKind::grey)
    picture->image = image::grey_as_rgb(std::move(picture->image));
  const std::string& chosen = picture->layer.name;
  const std::string shown_name =
      chosen.empty() ? parts.path : fmt::format("{}:{}", parts.path, chosen);
  return ComparedPicture{shown_name, parts.path, std::move(*picture)};
}

Status check_same_size(const std::string& name_a, const image::Image& a, const std::string& name_b,
                       const image::Image& b) {
  if (a.width == b.width && a.height == b.height) return Success{};
  return Error{fmt::format("{} has {}x{} pixels but {} has {}x{}; only pictures of the same size "
                           "can be compared",
                           name_a, a.width, a.height, name_b, b.width, b.height)};
}

Status check_comparable(const ComparedPicture& a, const ComparedPicture& b) {
  const image::LayerInfo &la = a.picture.layer, &lb = b.picture.layer;
  const bool picture_a = image::is_picture(la.kind), picture_b = image::is_picture(lb.kind);
  if (picture_a != picture_b || (!picture_a && la.kind != lb.kind))
    return Error{fmt::format("{} is {} but {} is {}; choose layers of one kind by --layer NAME or "
                             "FILE:NAME",
                             a.name, kind_in_words(la), b.name, kind_in_words(lb))};
  if (Status ok = check_same_size(a.name, a.picture.image, b.name, b.picture.image); !ok)
    return ok.error();
  if (la.display.x != lb.display.x || la.display.y != lb.display.y)
    return Error{fmt::format("{} begins at pixel ({}, {}) but {} at ({}, {}); only pictures of the "
                             "same display window can be compared",
                             a.name, la.display.x, la.display.y, b.name, lb.display.x,
                             lb.display.y)};
  if (std::fabs(la.pixel_aspect - lb.pixel_aspect) > 1e-4)
    return Error{fmt::format("{} has pixels {:.5g} times as wide as high but {} {:.5g} times; only "
                             "pictures of the same pixels can be compared",
                             a.name, la.pixel_aspect, b.name, lb.pixel_aspect)};
  const Window known_a = known_part(la), known_b = known_part(lb);
  if (!(known_a == known_b))
    say("warning: of {} the pixels {} are known, of {} {}; the others count as black\n", a.name,
        image::describe(known_a), b.name, image::describe(known_b));
  return Success{};
}

} // namespace openltc::cli
