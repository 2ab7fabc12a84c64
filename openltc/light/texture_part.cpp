// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/texture_part.h"

#include "openltc/base/memory_budget.h"
#include "openltc/base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace openltc::light {

namespace {

// Rows that one thread makes one after the other.
constexpr int k_rows_together = 16;

float sane(float x) { return x > 0 ? std::min(x, std::numeric_limits<float>::max()) : 0.0f; }

// That `weight` of pixel `from` goes into pixel `to` of the reduced ones.
struct Share {
  int to, from;
  float weight;
};

// For the reduced pixels first .. end - 1 along one axis; `to` and `from` both never fall.
std::vector<Share> shares_of(int from_size, int to_size, int first, int end) {
  std::vector<Share> shares;
  const double scale = double(from_size) / to_size;
  for (int i = first; i < end; ++i) {
    const double lower = i * scale, upper = (i + 1) * scale;
    const int last = std::min(int(std::ceil(upper)), from_size);
    for (int k = int(lower); k < last; ++k)
      shares.push_back(
          {i, k, float((std::min(upper, k + 1.0) - std::max(lower, double(k))) / scale)});
  }
  return shares;
}

double pixel_of(double coordinate, int size) {
  return std::clamp(coordinate * size - 0.5, 0.0, size - 1.0);
}

// The pixels that bilinear looks at between two coordinates, and one more for rounding.
void span_of(double low, double high, int size, int& first, int& end) {
  first = std::max(int(pixel_of(low, size)) - 1, 0);
  end = std::min(int(pixel_of(high, size)) + 3, size);
}

} // namespace

Vec3f TexturePart::bilinear(double u, double v) const {
  const double x = pixel_of(u, width), y = pixel_of(v, height);
  const int left = int(x), top = int(y);
  const int right = std::min(left + 1, width - 1), bottom = std::min(top + 1, height - 1);
  const float fx = float(x - left), fy = float(y - top);
  const auto at = [&](int column, int row) {
    return pixels.rgb(std::clamp(column - x0, 0, pixels.width - 1),
                      std::clamp(row - y0, 0, pixels.height - 1));
  };
  const Vec3f a = at(left, top) * (1 - fx) + at(right, top) * fx;
  const Vec3f b = at(left, bottom) * (1 - fx) + at(right, bottom) * fx;
  return a * (1 - fy) + b * fy;
}

Result<TexturePart> reduced_part(const image::Texels& texture, int columns, int rows,
                                 const TextureRange& range, const std::string& name) {
  TexturePart part;
  part.width = columns;
  part.height = rows;
  int x_end = 0, y_end = 0;
  span_of(range.u_low, range.u_high, columns, part.x0, x_end);
  span_of(range.v_low, range.v_high, rows, part.y0, y_end);
  const int width = x_end - part.x0, height = y_end - part.y0;
  if (Status ok =
          memory_budget().check(std::uint64_t(width) * std::uint64_t(height) * 3 * sizeof(float),
                                fmt::format("{}: what it shows of its texture", name));
      !ok)
    return ok.error();
  part.pixels = image::Image(width, height, 3);

  const std::vector<Share> across = shares_of(texture.width, columns, part.x0, x_end);
  const int groups = (height + k_rows_together - 1) / k_rows_together;
  parallel_for(groups, 0, [&](std::int64_t group) {
    const int first = part.y0 + int(group) * k_rows_together;
    // One row of the texture, reduced along it.
    std::vector<float> wide(std::size_t(width) * 3);
    int is_of = -1;
    for (const Share& down :
         shares_of(texture.height, rows, first, std::min(first + k_rows_together, y_end))) {
      if (is_of != down.from) {
        std::fill(wide.begin(), wide.end(), 0.0f);
        for (const Share& share : across) {
          const Vec3f value = texture.rgb(share.from, down.from);
          float* const to = wide.data() + 3 * std::size_t(share.to - part.x0);
          to[0] += share.weight * sane(value.x);
          to[1] += share.weight * sane(value.y);
          to[2] += share.weight * sane(value.z);
        }
        is_of = down.from;
      }
      float* const to = part.pixels.pixel(0, down.to - part.y0);
      for (std::size_t i = 0; i < wide.size(); ++i)
        to[i] += down.weight * wide[i];
    }
  });
  return part;
}

} // namespace openltc::light
