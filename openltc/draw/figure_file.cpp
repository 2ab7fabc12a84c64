// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/draw/figure_file.h"

#include "openltc/base/address_space.h"
#include "openltc/base/atomic_file.h"
#include "openltc/image/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#ifdef OPENLTC_RSVG
#include <librsvg/rsvg.h>
#endif

namespace openltc::draw {

namespace {

bool ends_with(const std::string& path, std::string_view ending) {
  if (path.size() < ending.size()) return false;
  return std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char a, char b) {
    return a == std::tolower(static_cast<unsigned char>(b));
  });
}

[[maybe_unused]] constexpr const char* k_no_rsvg =
    "this build has no librsvg to make PNG pictures of figures; install "
    "librsvg2-dev and build again, or write .svg";

} // namespace

Status check_extension(const std::string& path) {
  if (ends_with(path, ".svg")) return Success{};
  if (!ends_with(path, ".png"))
    return Error{fmt::format("{}: figures are written as .svg or .png", path)};
#ifdef OPENLTC_RSVG
  return Success{};
#else
  return Error{fmt::format("{}: {}", path, k_no_rsvg)};
#endif
}

Status write_figure(const std::string& path, const Figure& figure, Theme theme, double scale) {
  if (Status ok = check_extension(path); !ok) return ok;
  if (ends_with(path, ".png")) {
    const Result<image::Image> picture =
        rasterise(to_svg(figure, theme == Theme::automatic ? Theme::light : theme), scale);
    if (!picture) return Error{fmt::format("{}: {}", path, picture.error().message)};
    return image::write_png(path, *picture);
  }
  const std::string svg = to_svg(figure, theme);
  return write_atomically(path, [&](const std::string& temporary) -> Status {
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file) return Error{fmt::format("{}: cannot write: {}", path, std::strerror(errno))};
    const bool written = std::fwrite(svg.data(), 1, svg.size(), file) == svg.size();
    if (std::fclose(file) != 0 || !written)
      return Error{fmt::format("{}: cannot write: {}", path, std::strerror(errno))};
    return Success{};
  });
}

#ifdef OPENLTC_RSVG

namespace {

// What librsvg and the libraries below it take for fonts and threads, of which each reserves more
// than it uses. Where one does not get it, it ends the process or waits for ever.
constexpr std::uint64_t k_rsvg_bytes = std::uint64_t(512) << 20;
constexpr int k_max_side = 32767; // of a picture of cairo

} // namespace

Result<image::Image> rasterise(const std::string& svg, double scale) {
  if (!(scale > 0) || !std::isfinite(scale))
    return Error{fmt::format("the scale {} is not a positive number", scale)};
  if (!has_address_space(k_rsvg_bytes))
    return Error{"not enough memory to draw the figure as .png; .svg needs less"};
  GError* error = nullptr;
  RsvgHandle* handle =
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error);
  const auto failure = [&](const char* what) {
    const std::string message = error ? error->message : what;
    if (error) g_error_free(error);
    if (handle) g_object_unref(handle);
    return Error{fmt::format("librsvg cannot draw the figure: {}", message)};
  };
  if (!handle) return failure("not understood");
  gdouble width = 0, height = 0;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height))
    return failure("it has no size");
  const double wide = std::ceil(width * scale), high = std::ceil(height * scale);
  if (!(wide >= 1 && high >= 1 && wide <= k_max_side && high <= k_max_side))
    return failure(fmt::format("{}x{} pixels cannot be drawn", wide, high).c_str());
  const int columns = int(wide), rows = int(high);
  // Four bytes a pixel there, sixteen here.
  if (!has_address_space(std::uint64_t(columns) * std::uint64_t(rows) * 20 + k_rsvg_bytes))
    return failure("not enough memory for its pixels");
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, columns, rows);
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
    cairo_surface_destroy(surface);
    return failure("not enough memory");
  }
  cairo_t* cairo = cairo_create(surface);
  cairo_scale(cairo, scale, scale);
  const RsvgRectangle viewport{0, 0, width, height};
  const bool drawn = rsvg_handle_render_document(handle, cairo, &viewport, &error);
  cairo_destroy(cairo);
  cairo_surface_flush(surface);
  image::Image picture;
  const unsigned char* data = cairo_image_surface_get_data(surface);
  if (drawn && data) {
    picture = image::Image(columns, rows, 4);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        // Premultiplied, one native word a pixel.
        std::uint32_t word = 0;
        std::memcpy(&word, data + std::ptrdiff_t(y) * stride + std::ptrdiff_t(x) * 4, 4);
        const float alpha = float(word >> 24) / 255.0f;
        float* pixel = picture.pixel(x, y);
        for (int c = 0; c < 3; ++c)
          pixel[c] = alpha > 0 ? float((word >> (16 - 8 * c)) & 255u) / 255.0f / alpha : 0.0f;
        pixel[3] = alpha;
      }
  }
  cairo_surface_destroy(surface);
  if (picture.empty()) return failure("no memory");
  g_object_unref(handle);
  return picture;
}

#else

Result<image::Image> rasterise(const std::string&, double) { return Error{k_no_rsvg}; }

#endif

} // namespace openltc::draw
