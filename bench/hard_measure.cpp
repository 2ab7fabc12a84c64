// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "bench/hard_measure.h"

#include "openltc/image/compare/flip_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace openltc::bench {

namespace {

// The mean of a pixel's three channels.
double grey(const image::Image& image, std::size_t pixel) {
  const float* rgb = image.data.data() + pixel * 3;
  return (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3;
}

// Sorts the values.
double quantile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

double sum_of(const image::Image& image) {
  double sum = 0;
  for (const float v : image.data)
    sum += double(v);
  return sum;
}

double sum_of_differences(const image::Image& a, const image::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    sum += std::abs(double(a.data[i]) - double(b.data[i]));
  return sum;
}

// |a - b| / (reference + least) where `picture` or the reference is lit.
std::vector<double> relative_differences(const image::Image& picture, const image::Image& reference,
                                         const image::Image& a, const image::Image& b) {
  const double least = k_lit * sum_of(reference) / double(reference.data.size());
  std::vector<double> relative;
  for (std::size_t pixel = 0; pixel < reference.pixel_count(); ++pixel) {
    const double truth = grey(reference, pixel);
    if (std::max(grey(picture, pixel), truth) > least)
      relative.push_back(std::abs(grey(a, pixel) - grey(b, pixel)) / (truth + least));
  }
  return relative;
}

// Infinite where there is no error.
double ratio(double noise, double error) {
  return error > 0 ? noise / error : std::numeric_limits<double>::infinity();
}

} // namespace

std::optional<double> noise_over_error(const image::Image& picture,
                                       const HardReference& reference) {
  const image::Image& truth = reference.radiance;
  if (!(sum_of(truth) > 0)) return {};
  // The mean of both halves differs from the first by half of what the halves differ by.
  const image::Image& half = reference.half;
  std::vector<double> noise = relative_differences(picture, truth, half, truth);
  std::vector<double> error = relative_differences(picture, truth, picture, truth);
  return std::max(ratio(sum_of_differences(half, truth), sum_of_differences(picture, truth)),
                  ratio(quantile(noise, 0.5), quantile(error, 0.5)));
}

HardErrors hard_errors(const image::Image& picture, const HardReference& reference) {
  HardErrors errors;
  image::FlipComparisonOptions flip;
  flip.scene_linear = true;
  errors.flip = image::compare_flip(picture, reference.radiance, flip).mean;
  const double light = sum_of(reference.radiance);
  errors.mean_nits = sum_of(picture) / double(picture.data.size());
  if (!(light > 0)) return errors;

  errors.of_light = sum_of_differences(picture, reference.radiance) / light;
  errors.energy = sum_of(picture) / light - 1;
  errors.noise_over_error = noise_over_error(picture, reference);
  std::vector<double> relative =
      relative_differences(picture, reference.radiance, picture, reference.radiance);
  errors.median_relative = quantile(relative, 0.5);
  errors.p95_relative = quantile(relative, 0.95);
  return errors;
}

} // namespace openltc::bench
