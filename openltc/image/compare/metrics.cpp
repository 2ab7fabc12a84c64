// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/compare/metrics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace openltc::image {

namespace {

std::array<double, 3> values_of(const Image& image, std::size_t pixel) {
  const float* p = image.data.data() + pixel * std::size_t(image.channels);
  if (image.channels < 3) return {double(p[0]), double(p[0]), double(p[0])};
  return {double(p[0]), double(p[1]), double(p[2])};
}

bool all_finite(const std::array<double, 3>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// Calls f(pixel, a, b) for every pixel that counts.
template <class F>
void for_each_counted(const Image& a, const Image& b, std::span<const std::uint8_t> mask, F&& f) {
  for (std::size_t i = 0; i < a.pixel_count(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    const auto va = values_of(a, i), vb = values_of(b, i);
    if (all_finite(va) && all_finite(vb)) f(i, va, vb);
  }
}

} // namespace

std::vector<std::uint8_t> mask_of(const Image& picture) {
  std::vector<std::uint8_t> mask(picture.pixel_count());
  std::size_t i = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x, ++i) {
      const Vec3f v = picture.rgb(x, y);
      mask[i] = v.x > 0.0f || v.y > 0.0f || v.z > 0.0f;
    }
  return mask;
}

Metrics compare(const Image& a, const Image& b, const MetricOptions& options) {
  assert(a.width == b.width && a.height == b.height && !a.empty());
  assert(options.mask.empty() || options.mask.size() == a.pixel_count());
  Metrics m;

  // Count, and measure the reference.
  for (std::size_t i = 0; i < a.pixel_count(); ++i) {
    if (!options.mask.empty() && options.mask[i] == 0) {
      ++m.masked_count;
      continue;
    }
    const bool finite_a = all_finite(values_of(a, i)), finite_b = all_finite(values_of(b, i));
    m.non_finite_a += !finite_a;
    m.non_finite_b += !finite_b;
    m.non_finite_count += !(finite_a && finite_b);
  }
  m.pixel_count = a.pixel_count() - m.masked_count - m.non_finite_count;
  m.psnr = std::numeric_limits<double>::infinity();
  if (m.pixel_count == 0) return m;
  const double n = 3.0 * double(m.pixel_count); // grey counts three times, which changes no mean
  double sum_abs_b = 0.0;
  for_each_counted(a, b, options.mask, [&](std::size_t, const auto&, const auto& vb) {
    for (double v : vb) {
      sum_abs_b += std::fabs(v);
      m.psnr_peak = std::max(m.psnr_peak, std::fabs(v));
    }
  });
  m.eps = options.relative_epsilon * sum_abs_b / n;
  if (!(m.eps > 0.0)) m.eps = 1e-12;

  // Sum the differences.
  const auto place = [&](std::size_t i) {
    return PixelPlace{int(i % std::size_t(a.width)), int(i / std::size_t(a.width))};
  };
  m.max_abs_at = m.max_relative_at = {-1, -1};
  for_each_counted(a, b, options.mask, [&](std::size_t i, const auto& va, const auto& vb) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = va[c] - vb[c], size = std::fabs(difference);
      const double relative = size / (std::fabs(vb[c]) + m.eps);
      m.mean_a += va[c];
      m.mean_b += vb[c];
      m.bias += difference;
      m.mae += size;
      m.mse += difference * difference;
      m.relative_mse += difference * difference / (vb[c] * vb[c] + m.eps * m.eps);
      m.mean_relative += relative;
      if (size > m.max_abs || m.max_abs_at.x < 0) m.max_abs_at = place(i), m.max_abs = size;
      if (relative > m.max_relative || m.max_relative_at.x < 0)
        m.max_relative_at = place(i), m.max_relative = relative;
    }
  });
  for (double* sum :
       {&m.mean_a, &m.mean_b, &m.bias, &m.mae, &m.mse, &m.relative_mse, &m.mean_relative})
    *sum /= n;
  m.rmse = std::sqrt(m.mse);
  if (m.mse > 0.0) m.psnr = 10.0 * std::log10(m.psnr_peak * m.psnr_peak / m.mse);
  return m;
}

} // namespace openltc::image
