// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// One-dimensional filters along the rows or the columns of a single channel. Beyond its border a
// picture continues with its border pixel.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace openltc::image {

/// One channel of a picture; row after row, top first.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> data;
  Plane(int width_, int height_)
      : width(width_), height(height_), data(std::size_t(width_) * std::size_t(height_), 0.0f) {}
};

/// An odd number of weights, the middle one for the pixel itself.
struct Kernel {
  std::vector<float> weights;
  explicit Kernel(std::span<const double> values) : weights(values.begin(), values.end()) {}
  int radius() const { return int(weights.size() / 2); }
  Kernel scaled(double factor) const {
    Kernel k = *this;
    for (float& w : k.weights)
      w = float(double(w) * factor);
    return k;
  }
};

/// out(x, y) = sum over i of weight[i] in(x + i - radius, y).
Plane convolve_rows(const Plane& in, const Kernel& kernel);

/// out(x, y) = sum over i of weight[i] in(x, y + i - radius).
Plane convolve_columns(const Plane& in, const Kernel& kernel);

/// The same, added to `out`, which has the size of `in`.
void add_convolved_columns(const Plane& in, const Kernel& kernel, Plane& out);

} // namespace openltc::image
