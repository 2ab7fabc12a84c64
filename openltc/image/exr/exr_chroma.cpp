// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: The OpenEXR project, "Technical Introduction to OpenEXR", luminance/chroma images, and
// ImfRgbaYca.h, whose low-pass filter is that of its writer: 27 taps of a windowed sinc for half
// the rate. To double the rate, samples stay, and what lies between is a sum over the seven on each
// side. Beyond the edge the last sample goes on.

#include "openltc/image/exr/exr_chroma.h"

#include <algorithm>
#include <array>

namespace openltc::image {

namespace {

// Weights of the samples at distances 1, 3, 5 ... on either side; twice their sum is 1.
constexpr std::array<float, 7> k_weights = {0.627123f, -0.186077f, 0.087929f, -0.043159f,
                                            0.019597f, -0.007540f, 0.002128f};

// Values of one line, `stride` apart: those at odd places from those at even ones.
void reconstruct_line(float* line, int count, std::size_t stride) {
  const int last = (count - 1) / 2 * 2; // the last sample
  for (int i = 1; i < count; i += 2) {
    float sum = 0.0f;
    for (std::size_t k = 0; k < k_weights.size(); ++k) {
      const int distance = 2 * int(k) + 1;
      const int left = std::max(i - distance, 0), right = std::min(i + distance, last);
      sum += k_weights[k] * (line[std::size_t(left) * stride] + line[std::size_t(right) * stride]);
    }
    line[std::size_t(i) * stride] = sum;
  }
}

} // namespace

void reconstruct_chroma(Image& plane, int step_x, int step_y) {
  if (step_x == 2)
    for (int y = 0; y < plane.height; y += step_y)
      reconstruct_line(plane.pixel(0, y), plane.width, 1);
  if (step_y == 2)
    for (int x = 0; x < plane.width; ++x)
      reconstruct_line(plane.pixel(x, 0), plane.height, std::size_t(plane.width));
}

void rgb_from_luminance_chroma(Image& image, const ColorMatrix& xyz_from_rgb) {
  const float red = float(xyz_from_rgb[1][0]), green = float(xyz_from_rgb[1][1]),
              blue = float(xyz_from_rgb[1][2]);
  for (std::size_t i = 0; i < image.data.size(); i += std::size_t(image.channels)) {
    float* p = &image.data[i];
    const float y = p[0], ry = p[1], by = p[2];
    p[0] = (ry + 1.0f) * y;
    p[2] = (by + 1.0f) * y;
    // Grey stays grey to the last digit.
    p[1] = ry == 0.0f && by == 0.0f ? y : (y - p[0] * red - p[2] * blue) / green;
  }
}

} // namespace openltc::image
