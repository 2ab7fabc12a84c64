// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/camera_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace openltc::render {

CameraRays::CameraRays(const scene::Camera& camera, int width, int height) : camera_(camera) {
  const float aspect = float(width) / float(height);
  if (camera.projection == scene::Projection::perspective) {
    half_height_ = std::tan(0.5f * camera.fov_y_rad);
    footprint_base_ = 0;
    footprint_slope_ = 2 * half_height_ / float(height);
  } else {
    half_height_ = 0.5f * camera.height;
    footprint_base_ = camera.height / float(height);
    footprint_slope_ = 0;
  }
  half_width_ = half_height_ * aspect;
  scale_x_ = 2 / float(width);
  scale_y_ = 2 / float(height);
}

CameraRay CameraRays::ray(float x, float y) const {
  const float sx = (x * scale_x_ - 1) * half_width_;
  const float sy = (1 - y * scale_y_) * half_height_;
  const float infinity = std::numeric_limits<float>::infinity();
  CameraRay ray;
  if (camera_.projection == scene::Projection::perspective) {
    const Vec3f d = camera_.forward + camera_.right * sx + camera_.up * sy;
    const float stretch = length(d); // planes of the camera are measured along its axis
    ray.origin = camera_.position;
    ray.direction = d / stretch;
    ray.near = camera_.near * stretch;
    ray.far = camera_.far > 0 ? camera_.far * stretch : infinity;
  } else {
    ray.origin = camera_.position + camera_.right * sx + camera_.up * sy;
    ray.direction = camera_.forward;
    ray.near = camera_.near;
    ray.far = camera_.far > 0 ? camera_.far : infinity;
  }
  return ray;
}

namespace {

constexpr float k_radius = 1.5f;
constexpr int k_cdf_size = 256;

// Inverse of the running integral of the window, tabulated. Its four cosine terms: Harris 1978, "On
// the Use of Windows for Harmonic Analysis with the Discrete Fourier Transform", equation 33.
std::array<float, k_cdf_size + 1> make_inverse_cdf() {
  constexpr int k_fine = 8192;
  constexpr double pi = std::numbers::pi;
  std::array<double, k_fine + 1> cdf{};
  for (int i = 0; i < k_fine; ++i) {
    const double t = (i + 0.5) / k_fine * 2 * pi;
    const double w =
        0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
    cdf[std::size_t(i) + 1] = cdf[std::size_t(i)] + w;
  }
  std::array<float, k_cdf_size + 1> inverse{};
  std::size_t k = 0;
  for (int i = 0; i <= k_cdf_size; ++i) {
    const double wanted = cdf[k_fine] * i / k_cdf_size;
    while (k < k_fine && cdf[k + 1] < wanted)
      ++k;
    const double step = k < k_fine ? cdf[k + 1] - cdf[k] : 1;
    const double x = (double(k) + (step > 0 ? (wanted - cdf[k]) / step : 0)) / k_fine;
    inverse[std::size_t(i)] = float((2 * x - 1) * double(k_radius));
  }
  return inverse;
}

} // namespace

float filter_offset(float u) {
  static const std::array<float, k_cdf_size + 1> inverse = make_inverse_cdf();
  const float x = std::clamp(u, 0.0f, 1.0f) * float(k_cdf_size);
  const int i = std::min(int(x), k_cdf_size - 1);
  const float a = inverse[std::size_t(i)], b = inverse[std::size_t(i) + 1];
  return a + (b - a) * (x - float(i));
}

} // namespace openltc::render
