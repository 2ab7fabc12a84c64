// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/compare/convolve.h"

#include <algorithm>

namespace openltc::image {

namespace {

// out[x] += weight * in[x]: the one inner loop, which compilers turn into lanes.
void add_scaled(const float* in, float weight, float* out, std::size_t count) {
  for (std::size_t x = 0; x < count; ++x)
    out[x] += weight * in[x];
}

} // namespace

Plane convolve_rows(const Plane& in, const Kernel& kernel) {
  Plane out(in.width, in.height);
  const std::size_t width = std::size_t(in.width);
  const std::size_t radius = std::size_t(kernel.radius());
  std::vector<float> padded(width + 2 * radius);
  for (std::size_t y = 0; y < std::size_t(in.height); ++y) {
    const float* row = in.data.data() + y * width;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width, padded.begin() + std::ptrdiff_t(radius));
    std::fill_n(padded.begin() + std::ptrdiff_t(radius + width), radius, row[width - 1]);
    for (std::size_t i = 0; i < kernel.weights.size(); ++i)
      add_scaled(padded.data() + i, kernel.weights[i], out.data.data() + y * width, width);
  }
  return out;
}

void add_convolved_columns(const Plane& in, const Kernel& kernel, Plane& out) {
  const std::size_t width = std::size_t(in.width);
  for (int y = 0; y < in.height; ++y)
    for (std::size_t i = 0; i < kernel.weights.size(); ++i) {
      const int from = std::clamp(y + int(i) - kernel.radius(), 0, in.height - 1);
      add_scaled(in.data.data() + std::size_t(from) * width, kernel.weights[i],
                 out.data.data() + std::size_t(y) * width, width);
    }
}

Plane convolve_columns(const Plane& in, const Kernel& kernel) {
  Plane out(in.width, in.height);
  add_convolved_columns(in, kernel, out);
  return out;
}

} // namespace openltc::image
