// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/options_check.h"

#include "openltc/image/file.h"

#include <fmt/format.h>

#include <cstddef>

namespace openltc::render {

namespace {

constexpr int k_max_size = 32768; // pixels on a side

bool is_whole_tiles(const PixelWindow& w, const RenderOptions& o) {
  const auto side = [](int begin, int end, int size) {
    return begin >= 0 && begin < end && end <= size && begin % k_tile_side == 0 &&
           (end % k_tile_side == 0 || end == size);
  };
  return side(w.x0, w.x1, o.width) && side(w.y0, w.y1, o.height);
}

} // namespace

PixelWindow window_of(const RenderOptions& o) {
  return o.window.value_or(PixelWindow{0, 0, o.width, o.height});
}

Status check_options(const RenderOptions& o) {
  if (o.width < 1 || o.height < 1 || o.width > k_max_size || o.height > k_max_size)
    return Error{fmt::format("picture size {}x{}: each side must be 1 to {} pixels", o.width,
                             o.height, k_max_size)};
  if (std::size_t(o.width) * std::size_t(o.height) > image::k_max_pixels)
    return Error{fmt::format("picture size {}x{}: more than {} million pixels in all", o.width,
                             o.height, image::k_max_pixels / 1000000)};
  if (o.window && !is_whole_tiles(*o.window, o))
    return Error{
        fmt::format("window {},{} to {},{}: it must lie in the picture and begin and end at "
                    "multiples of {} pixels or the picture's edge",
                    o.window->x0, o.window->y0, o.window->x1, o.window->y1, k_tile_side)};
  if (o.samples < 1 || o.samples > (1 << 20))
    return Error{fmt::format("samples per pixel: {} is not in 1 to {}", o.samples, 1 << 20)};
  if (o.shadow_samples < 0 || o.shadow_samples > 4096)
    return Error{fmt::format("shadow samples: {} is not in 0 to 4096", o.shadow_samples)};
  if (!(o.light_error >= 0 && o.light_error <= 1))
    return Error{fmt::format("light error: {} is not in 0 to 1", o.light_error)};
  return Success{};
}

} // namespace openltc::render
