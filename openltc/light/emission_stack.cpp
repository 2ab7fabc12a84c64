// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources:
//   Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed
//     Cosines", section 5.2 (textured lights: prefilter the texture and what is around it);
//   Burt, Adelson 1983, "The Laplacian Pyramid as a Compact Image Code" (a Gaussian by repeated
//     small filters);
//   Knutsson, Westin 1993, "Normalized and Differential Convolution" (image times mask over mask).
//
// One level becomes the next by the filter [1 3 3 1] / 8 along rows, then columns, at every second
// place. Its variance is 3/4 of a fine texel squared; repeated, v' = (v + 3/4) / 4 tends to v =
// 1/4: a standard deviation of half a texel of whichever level. The light is surrounded by nothing:
// both the texture times the outline and the outline itself are zero there.

#include "openltc/light/emission_stack.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/emission_outline.h"
#include "openltc/light/emitter.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/texture_part.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace openltc::light {

namespace {

// Small enough a grid to be cheap, fine enough that a disk's rim shows.
constexpr int k_min_side = 32;
// What a texel of the finest level takes: with all levels and its cell; while they are made.
constexpr std::uint64_t k_texel_bytes = 26, k_working_bytes = 56;

void copy3(float* out, Vec3d v) {
  out[0] = float(v.x);
  out[1] = float(v.y);
  out[2] = float(v.z);
}

int power_of_two_at_least(double x) {
  int n = 1;
  while (n < x && n < (1 << 20))
    n *= 2;
  return n;
}

struct Level {
  int columns, rows;
  std::vector<float> texels; // 4 floats each
};

// Texels 2i - 1 .. 2i + 2 by 1 3 3 1, those that there are. `stride` floats from one to the next.
void decimate(const float* from, int count, std::size_t stride, float* to, std::size_t to_stride) {
  constexpr float weights[4] = {1, 3, 3, 1};
  for (int i = 0; i < count / 2; ++i) {
    const int first = std::max(2 * i - 1, 0), last = std::min(2 * i + 2, count - 1);
    float total = 0;
    for (int at = first; at <= last; ++at)
      total += weights[at - 2 * i + 1];
    for (std::size_t c = 0; c < 4; ++c) {
      float sum = 0;
      for (int at = first; at <= last; ++at)
        sum += weights[at - 2 * i + 1] * from[std::size_t(at) * stride + c];
      to[std::size_t(i) * to_stride + c] = sum / total;
    }
  }
}

Level next_level(const Level& fine) {
  Level half{std::max(fine.columns / 2, 1), fine.rows, {}};
  half.texels.resize(std::size_t(half.columns) * std::size_t(half.rows) * 4);
  if (fine.columns == 1)
    half.texels = fine.texels;
  else
    for (int y = 0; y < fine.rows; ++y)
      decimate(fine.texels.data() + std::size_t(y * fine.columns) * 4, fine.columns, 4,
               half.texels.data() + std::size_t(y * half.columns) * 4, 4);
  if (fine.rows == 1) return half;
  Level next{half.columns, half.rows / 2, {}};
  const std::size_t stride = std::size_t(half.columns) * 4;
  next.texels.resize(stride * std::size_t(next.rows));
  for (std::size_t x = 0; x < std::size_t(half.columns); ++x)
    decimate(half.texels.data() + 4 * x, half.rows, stride, next.texels.data() + 4 * x, stride);
  return next;
}

// The finest level's mean: the light's, with its share of the rectangle.
std::vector<float> mean_of(const Level& level) {
  double sum[4] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < level.texels.size(); ++i)
    sum[i % 4] += double(level.texels[i]);
  const double count = double(level.columns) * level.rows;
  std::vector<float> mean;
  for (const double s : sum)
    mean.push_back(float(s / count));
  return mean;
}

template <class Outline>
Result<EmissionStack> build(const image::Texels& source, const Emitter& light,
                            const PlaneFrame& frame, const Outline& outline, const PlaneBox& box,
                            const EmissionStackOptions& options) {
  const Vec2d size = box.upper - box.lower;
  if (!(size.x > 0) || !(size.y > 0)) return wrong_light(light.name, "its outline has no extent");
  EmissionStack stack;
  EmissionTextureView& view = stack.view;
  const Vec3d texture_u = to_double(light.texture_u), texture_v = to_double(light.texture_v);
  const Vec3d u_gradient = texture_u / dot(texture_u, texture_u);
  const Vec3d v_gradient = texture_v / dot(texture_v, texture_v);
  const Vec3d box_corner = frame.origin + frame.u * box.lower.x + frame.v * box.lower.y;
  copy3(view.corner, box_corner);
  copy3(view.axis_u, frame.u);
  copy3(view.axis_v, frame.v);
  copy3(view.texture_origin, to_double(light.texture_corner));
  copy3(view.texture_u, u_gradient);
  copy3(view.texture_v, v_gradient);
  view.extent[0] = float(size.x);
  view.extent[1] = float(size.y);
  stack.texture = source;
  view.texture = source.colors();
  view.texture_columns = source.width;
  view.texture_rows = source.height;
  view.texture_channels = source.color_channels();

  // As many texels as the texture has pixels across the light, but no more than allowed.
  const auto pixels_along = [&](Vec3d axis, double extent) {
    return extent * std::max(std::abs(dot(axis, u_gradient)) * source.width,
                             std::abs(dot(axis, v_gradient)) * source.height);
  };
  const double wanted_columns = pixels_along(frame.u, size.x);
  const double wanted_rows = pixels_along(frame.v, size.y);
  const int max_side = std::max(power_of_two_at_least(options.max_side), 1);
  const int min_side = std::min(k_min_side, max_side);
  Level level{std::clamp(power_of_two_at_least(wanted_columns), min_side, max_side),
              std::clamp(power_of_two_at_least(wanted_rows), min_side, max_side),
              {}};
  // A texture too fine for that is reduced by the same factor first.
  const double excess_u = wanted_columns / level.columns, excess_v = wanted_rows / level.rows;
  const auto fewer = [](int pixels, double excess) {
    return std::clamp(int(std::ceil(pixels / std::max(excess, 1.0))), 1, pixels);
  };
  const std::string name = light.name.empty() ? "a light" : light.name;
  MemoryShare working;
  const std::uint64_t texels = std::uint64_t(level.columns) * std::uint64_t(level.rows);
  if (Status ok = stack.memory.take(texels * k_texel_bytes, name + ": its filtered texture"); !ok)
    return ok.error();
  if (Status ok = working.take(texels * k_working_bytes, name + ": its texture's filter"); !ok)
    return ok.error();
  const auto place_of = [&](int x, int y) {
    const Vec3d p = box_corner + frame.u * ((x + 0.5) / level.columns * size.x) +
                    frame.v * ((y + 0.5) / level.rows * size.y) - to_double(light.texture_corner);
    return Vec2d(dot(p, u_gradient), dot(p, v_gradient));
  };
  PlaneBox shown;
  for (const int x : {0, level.columns - 1})
    for (const int y : {0, level.rows - 1})
      shown.add(place_of(x, y));
  const Result<TexturePart> texture =
      reduced_part(source, fewer(source.width, excess_u), fewer(source.height, excess_v),
                   {shown.lower.x, shown.lower.y, shown.upper.x, shown.upper.y}, name);
  if (!texture) return texture.error();

  const std::vector<float> cover = coverage(outline, box, level.columns, level.rows);
  level.texels.resize(cover.size() * 4);
  for (int y = 0; y < level.rows; ++y)
    for (int x = 0; x < level.columns; ++x) {
      const Vec2d place = place_of(x, y);
      const Vec3f value = texture->bilinear(place.x, place.y);
      const std::size_t i = std::size_t(y) * std::size_t(level.columns) + std::size_t(x);
      float* texel = level.texels.data() + 4 * i;
      texel[0] = value.x * cover[i];
      texel[1] = value.y * cover[i];
      texel[2] = value.z * cover[i];
      texel[3] = cover[i];
    }
  const std::vector<float> mean = mean_of(level);
  if (!(mean[3] > 0)) return wrong_light(light.name, "its outline encloses nothing");
  stack.mean = Vec3f(mean[0], mean[1], mean[2]) / mean[3];

  stack.cells = make_emission_cells(level.texels, level.columns, level.rows);
  view.row_cdf = stack.cells.row_cdf.data();
  view.cell_cdf = stack.cells.cell_cdf.data();
  view.cell_columns = level.columns;
  view.cell_rows = level.rows;
  view.cell_share = stack.cells.share;

  for (;;) {
    const bool is_last = level.columns == 1 && level.rows == 1;
    if (is_last) level.texels = mean;
    stack.levels.insert(stack.levels.end(),
                        {std::int32_t(stack.texels.size() / 4), std::int32_t(level.columns),
                         std::int32_t(level.rows), 0});
    stack.texels.insert(stack.texels.end(), level.texels.begin(), level.texels.end());
    if (is_last) break;
    level = next_level(level);
  }
  view.texels = stack.texels.data();
  view.levels = stack.levels.data();
  view.level_count = int(stack.levels.size() / 4);
  return stack;
}

Status check_texture(const image::Texels& texture, const Emitter& light) {
  if (texture.empty()) return wrong_light(light.name, "its texture is empty");
  const float v2 = dot(light.texture_v, light.texture_v);
  const float u2 = dot(light.texture_u, light.texture_u);
  if (!(u2 > 0) || !(v2 > 0) || !std::isfinite(u2) || !std::isfinite(v2) ||
      !is_finite(light.texture_corner))
    return wrong_light(light.name, "the axes of its texture have no length");
  return Success{};
}

constexpr const char* k_no_direction = "the texture's u axis runs along the light's normal";

Vec3d normal_of(const EllipseLight& light) {
  return normalize(cross(to_double(light.half_u), to_double(light.half_v)));
}

// The texture's corners from the box of the outline in a frame whose v is downwards.
template <class Light>
void place(Light& light, int texture, Vec3f u_axis, Vec3d origin, Vec3d normal) {
  light.texture = texture;
  light.texture_u = u_axis;
  // Facing the light, with u to the right, up is u x (the light's normal, towards the viewer)
  // reversed: right x up = towards the viewer, so up = normal x right and down its negative.
  const Vec3d down = -cross(normal, to_double(u_axis));
  light.texture_v = Vec3f(float(down.x), float(down.y), float(down.z));
  PlaneFrame frame;
  if (!make_frame(light, origin, normal, frame)) return;
  PlaneBox box;
  outline_of(light, frame, box);
  float values[3];
  copy3(values, frame.origin + frame.u * box.lower.x + frame.v * box.lower.y);
  light.texture_corner = Vec3f(values[0], values[1], values[2]);
  copy3(values, frame.u * (box.upper.x - box.lower.x));
  light.texture_u = Vec3f(values[0], values[1], values[2]);
  copy3(values, frame.v * (box.upper.y - box.lower.y));
  light.texture_v = Vec3f(values[0], values[1], values[2]);
}

template <class Light>
Vec3f texture_mean(const Light& light, const std::vector<image::Texels>& textures) {
  if (light.texture < 0 || std::size_t(light.texture) >= textures.size()) return Vec3f(1.0f);
  const auto stack = build_emission_stack(textures[std::size_t(light.texture)], light, {256});
  return stack.ok() ? stack->mean : Vec3f(1.0f);
}

} // namespace

Result<EmissionStack> build_emission_stack(const image::Texels& texture, const PolygonLight& light,
                                           const EmissionStackOptions& options) {
  if (Status status = validate(light); !status.ok()) return status.error();
  if (Status status = check_texture(texture, light); !status.ok()) return status.error();
  PlaneFrame frame;
  if (!make_frame(light, to_double(light.vertices[0]), to_double(light.normal), frame))
    return wrong_light(light.name, k_no_direction);
  PlaneBox box;
  const PolygonOutline outline = outline_of(light, frame, box);
  return build(texture, light, frame, outline, box, options);
}

Result<EmissionStack> build_emission_stack(const image::Texels& texture, const EllipseLight& light,
                                           const EmissionStackOptions& options) {
  if (Status status = validate(light); !status.ok()) return status.error();
  if (Status status = check_texture(texture, light); !status.ok()) return status.error();
  PlaneFrame frame;
  if (!make_frame(light, to_double(light.center), normal_of(light), frame))
    return wrong_light(light.name, k_no_direction);
  PlaneBox box;
  const EllipseOutline outline = outline_of(light, frame, box);
  return build(texture, light, frame, outline, box, options);
}

Vec3f mean_of_texture(const PolygonLight& light, const std::vector<image::Texels>& textures) {
  return texture_mean(light, textures);
}

Vec3f mean_of_texture(const EllipseLight& light, const std::vector<image::Texels>& textures) {
  return texture_mean(light, textures);
}

void place_texture(PolygonLight& light, int texture, Vec3f u_axis) {
  place(light, texture, u_axis, to_double(light.vertices[0]), to_double(light.normal));
}

void place_texture(EllipseLight& light, int texture, Vec3f u_axis) {
  place(light, texture, u_axis, to_double(light.center), normal_of(light));
}

} // namespace openltc::light
