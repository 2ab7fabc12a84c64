// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A picture is drawn pixel by pixel, each the mean of a few places within it, so that what is cut
// off by an alpha cutoff keeps its area. A pixel that reaches beyond the part has the mean of what
// lies within, because the light's outline cuts it off once more; one beside the part has its
// neighbour's value, for interpolation.

#include "openltc/base/quote.h"
#include "openltc/light/emission_stack.h"
#include "openltc/scene/emissive/emissive_texture.h"
#include "openltc/scene/emissive/surface_emission.h"
#include "openltc/scene/triangle_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace openltc::scene {

namespace {

constexpr int k_least_side = 64;
constexpr std::size_t k_large_picture = 1 << 17; // pixels; fewer places in each

struct Pixel {
  Vec3f sum{0, 0, 0};
  std::uint16_t places = 0; // bits: which are done
};

// The picture's coordinates, in pixels, of points of the plane.
struct PictureFrame {
  Vec3d corner, u_gradient, v_gradient;
  int width = 1, height = 1;
  Vec2d at(Vec3d p) const {
    return {dot(p - corner, u_gradient) * width, dot(p - corner, v_gradient) * height};
  }
};

// The frame that texture_corner, texture_u and texture_v of a light describe.
PictureFrame frame_of(const light::PolygonLight& light) {
  const Vec3d u = to_double(light.texture_u), v = to_double(light.texture_v);
  return {to_double(light.texture_corner), u / dot(u, u), v / dot(v, v)};
}

Vec3d longest_edge(const light::PolygonLight& light) {
  Vec3d longest{0, 0, 0};
  std::size_t begin = 0;
  for (const std::uint32_t end : light.ring_end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3d edge =
          to_double(light.vertices[i + 1 < end ? i + 1 : begin]) - to_double(light.vertices[i]);
      if (dot(edge, edge) > dot(longest, longest)) longest = edge;
    }
    begin = end;
  }
  return longest;
}

// Makes a light's picture the part of itself from (x0, y0) to (x1, y1), in shares of its sides.
void crop(light::PolygonLight& light, double x0, double y0, double x1, double y1) {
  const PictureFrame frame = frame_of(light);
  const Vec3d normal = to_double(light.normal);
  // Directions in the plane that change one coordinate by 1 and leave the other alone.
  const Vec3d across_v = cross(frame.v_gradient, normal),
              across_u = cross(normal, frame.u_gradient);
  const Vec3d along_u = across_v / dot(across_v, frame.u_gradient);
  const Vec3d along_v = across_u / dot(across_u, frame.v_gradient);
  light.texture_corner = to_float(frame.corner + along_u * x0 + along_v * y0);
  light.texture_u = light.texture_u * float(x1 - x0);
  light.texture_v = light.texture_v * float(y1 - y0);
}

// Pixels without a value take the nearest one's of their row, rows without one that of a row near.
void fill_gaps(image::Image& picture, const std::vector<bool>& is_known) {
  const auto copy = [&](int x, int y, int from_x, int from_y) {
    std::copy_n(picture.pixel(from_x, from_y), 3, picture.pixel(x, y));
  };
  int last_row = -1;
  std::vector<int> empty_rows;
  for (int y = 0; y < picture.height; ++y) {
    int last = -1;
    for (int x = 0; x < picture.width; ++x) {
      if (!is_known[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)]) continue;
      // The gap before this pixel: its halves go to either side.
      for (int i = last + 1; i < x; ++i)
        copy(i, y, last >= 0 && i - last <= x - i ? last : x, y);
      last = x;
    }
    for (int i = last + 1; last >= 0 && i < picture.width; ++i)
      copy(i, y, last, y);
    if (last >= 0) {
      for (const int empty : empty_rows)
        for (int x = 0; x < picture.width; ++x)
          copy(x, empty, x, last_row >= 0 && empty - last_row <= y - empty ? last_row : y);
      empty_rows.clear();
      last_row = y;
    } else {
      empty_rows.push_back(y);
    }
  }
  for (const int empty : empty_rows)
    for (int x = 0; last_row >= 0 && x < picture.width; ++x)
      copy(x, empty, x, last_row);
}

} // namespace

Result<image::Image> SurfaceEmission::picture_of(const FlatPart& part, const Mesh& mesh,
                                                 const Extent& extent, light::PolygonLight& light,
                                                 int most_side, bool is_cutout,
                                                 MemoryShare& memory) const {
  const std::vector<Patch> patches = patches_of(part, mesh, extent);
  PictureFrame frame;
  // Along a texture's own texels where that is possible.
  bool is_placed = false;
  const Texture* const texture = finest();
  if (texture) {
    const TextureRef& ref =
        texture == alpha_ ? material_.base_color_texture : material_.emission_texture;
    // It may show its picture as often as it likes.
    is_placed = place_texture(mesh, ref, texture->image.width, texture->image.height,
                              Wrap::clamp_to_edge, Wrap::clamp_to_edge, part.source, light);
  }
  if (is_placed) {
    frame = frame_of(light);
    Vec2d lower(1e300, 1e300), upper(-1e300, -1e300);
    const double columns = texture->image.width, rows = texture->image.height;
    for (const Vec3d& p : part.points) {
      const Vec2d uv = frame.at(p + extent.center);
      lower = {std::min(lower.x, uv.x), std::min(lower.y, uv.y)};
      upper = {std::max(upper.x, uv.x), std::max(upper.y, uv.y)};
    }
    // Whole texels, with a little slack for rounding.
    const auto outwards = [](double low, double high, double count, double& from, double& to) {
      from = std::floor(low * count + 1e-3);
      to = std::max(std::ceil(high * count - 1e-3), from + 1);
    };
    double x0, x1, y0, y1;
    outwards(lower.x, upper.x, columns, x0, x1);
    outwards(lower.y, upper.y, rows, y0, y1);
    crop(light, x0 / columns, y0 / rows, x1 / columns, y1 / rows);
    const auto pixels = [&](double texels) {
      return int(std::ceil(texels / std::max(std::ceil(texels / most_side), 1.0)));
    };
    frame = frame_of(light);
    frame.width = pixels(x1 - x0);
    frame.height = pixels(y1 - y0);
  } else {
    light::place_texture(light, 0, to_float(longest_edge(light)));
    frame = frame_of(light);
    double texels = double(k_least_side) * k_least_side;
    if (texture)
      for (const Patch& patch : patches) {
        const TextureRef& ref =
            texture == alpha_ ? material_.base_color_texture : material_.emission_texture;
        const Vec2d a = coordinates(ref, patch.triangle, patch.corners[0]);
        const Vec2d ab = coordinates(ref, patch.triangle, patch.corners[1]) - a;
        const Vec2d ac = coordinates(ref, patch.triangle, patch.corners[2]) - a;
        texels += 0.5 * std::abs(ab.x * ac.y - ab.y * ac.x) * double(texture->image.pixel_count());
      }
    const double aspect = std::sqrt(double(length(light.texture_u) / length(light.texture_v)));
    const double side = std::sqrt(std::min(texels, double(most_side) * most_side));
    frame.width = int(std::clamp(side * aspect, 1.0, double(most_side)));
    frame.height = int(std::clamp(side / aspect, 1.0, double(most_side)));
  }
  light.texture = 0;

  const std::size_t width = std::size_t(frame.width);
  const std::size_t count = width * std::size_t(frame.height);
  const std::string what = fmt::format("mesh \"{}\": the picture of its light, {}x{} pixels",
                                       quote(mesh.name), frame.width, frame.height);
  if (Status ok = memory.take(count * 3 * sizeof(float), what); !ok) return ok.error();
  MemoryShare drawing(memory.budget());
  if (Status ok = drawing.take(count * (sizeof(Pixel) + 1), what); !ok) return ok.error();
  std::vector<Pixel> pixels(count);
  const int across = pixels.size() > k_large_picture ? 2 : 4;
  const std::uint16_t all = std::uint16_t((1u << (across * across)) - 1u);
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    Vec2d c[3];
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = frame.at(part.points[part.triangles[i][k]] + extent.center);
    const double area =
        (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
    if (!(std::abs(area) > 0) || !std::isfinite(area)) continue;
    const auto first = [](double low, int count) {
      return int(std::clamp(std::floor(low), 0.0, double(count - 1)));
    };
    const auto [low_y, high_y] = std::minmax({c[0].y, c[1].y, c[2].y});
    for (int y = first(low_y, frame.height); y <= first(high_y, frame.height); ++y) {
      const RowRange range = row_range(c, y, y + 1);
      if (!(range.low <= range.high)) continue;
      for (int x = first(range.low, frame.width); x <= first(range.high, frame.width); ++x) {
        Pixel& pixel = pixels[std::size_t(y) * width + std::size_t(x)];
        if (pixel.places == all) continue;
        for (int k = 0; k < across * across; ++k) {
          if (pixel.places >> k & 1) continue;
          const double px = x + (k % across + 0.5) / across - c[0].x;
          const double py = y + (k / across + 0.5) / across - c[0].y;
          const double b1 = (px * (c[2].y - c[0].y) - py * (c[2].x - c[0].x)) / area;
          const double b2 = ((c[1].x - c[0].x) * py - (c[1].y - c[0].y) * px) / area;
          // A little more than the triangle, so that no place falls between two.
          if (!(b1 >= -1e-9) || !(b2 >= -1e-9) || !(b1 + b2 <= 1 + 1e-9)) continue;
          const Patch& patch = patches[i];
          pixel.sum += at(patch.triangle, patch.corners[0] * (1 - b1 - b2) + patch.corners[1] * b1 +
                                              patch.corners[2] * b2);
          pixel.places = std::uint16_t(pixel.places | (1u << k));
        }
      }
    }
  }

  image::Image picture(frame.width, frame.height, 3);
  std::vector<bool> is_known(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    int places = 0;
    for (int k = 0; k < across * across; ++k)
      places += pixels[i].places >> k & 1;
    is_known[i] = places > 0 || is_cutout;
    if (places == 0) continue;
    const Vec3f value = pixels[i].sum / float(is_cutout ? across * across : places);
    float* to = picture.data.data() + 3 * i;
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
  }
  fill_gaps(picture, is_known);
  return picture;
}

} // namespace openltc::scene
