// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How far single precision is from the reference, over random lights of a shape, and how far the
// published formulas are.

#pragma once

#include "tests/shade/lights/light_fixture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace openltc::testing {

/// Of absolute differences. Integrals are shares, 0..1; a line counts as a tube whose diameter is a
/// tenth of its distance, relative to its integral where that exceeds 1, as it may for a line.
struct ErrorFigures {
  std::int64_t count = 0;
  double mean = 0, p99 = 0, largest = 0;
  std::uint64_t worst = 0;     ///< index of the largest
  std::int64_t noticeable = 0; ///< how many are beyond 1e-5
  float noticeable_below = 0;  ///< the largest roughness among those
};

struct ShapeErrors {
  LightShape shape;
  std::string surfaces;           ///< which roughness
  ErrorFigures diffuse, specular; ///< float, against the reference
  /// Published formulas in double, specular; the reference and they leave the light below the
  /// surface in.
  ErrorFigures published;
  /// The same against the true integral, without that light.
  ErrorFigures published_leaking;
  ErrorFigures published_fit; ///< rectangles and polygons: (l^2 + z)/(l + 1)
  double mean_integral = 0;
};

/// Case `index` of the campaign; the same for any number of threads.
LightCase error_case(LightShape shape, std::uint64_t index);

/// `count` random lights: from roughness 0.2 on, and below.
std::vector<ShapeErrors> measure_light_errors(LightShape shape, std::int64_t count,
                                              int threads = 0);

} // namespace openltc::testing
