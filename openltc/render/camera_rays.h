// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Camera rays and the reconstruction filter.

#pragma once

#include "openltc/scene/scene.h"

namespace openltc::render {

struct CameraRay {
  Vec3f origin;
  Vec3f direction; ///< unit, world space
  float near = 0, far = 0;
};

/// Rays of a camera through a picture of width x height pixels.
class CameraRays {
public:
  CameraRays(const scene::Camera& camera, int width, int height);

  /// Ray through (x, y) in pixels from the top left corner of the picture.
  CameraRay ray(float x, float y) const;

  /// Width of a pixel `distance` metres away, across the ray, in metres.
  float footprint(float distance) const { return footprint_base_ + footprint_slope_ * distance; }

private:
  scene::Camera camera_;
  float half_width_, half_height_; ///< of the view at distance 1, or of the orthographic window
  float scale_x_, scale_y_;
  float footprint_base_, footprint_slope_;
};

/// Offset from a pixel's centre, in pixels, distributed as the Blackman-Harris window of radius
/// 1.5 (filter importance sampling: Ernst, Stamminger, Greiner 2006). Averaging samples so placed,
/// with equal weights, is filtering with that window; pixels stay independent of each other.
float filter_offset(float u);

} // namespace openltc::render
