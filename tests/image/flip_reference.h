// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Made by tools/make_flip_reference.py with flip-evaluator 1.7; do not edit.
// clang-format off

#pragma once

namespace openltc::image::test {

struct FlipReference {
  const char* name;
  bool hdr;
  float pixels_per_degree;
  double mean, start_exposure, stop_exposure;
  int exposure_count;
  float pixels[6]; // at k_flip_pixels
};

inline constexpr int k_flip_pixels[6][2] = {{0, 0}, {95, 63}, {48, 32}, {60, 20}, {11, 12}, {70, 50}};

inline constexpr FlipReference k_flip_references[] = {
    {"noise", false, 67.0f, 0.1213735, 0.00000, 0.00000, 0,
     {0.082089f, 0.212395f, 0.087898f, 0.144567f, 0.112180f, 0.159406f}},
    {"shifted edges", false, 67.0f, 0.1694250, 0.00000, 0.00000, 0,
     {0.000000f, 0.742912f, 0.393866f, 0.393866f, 0.227565f, 0.589132f}},
    {"swapped colours", false, 67.0f, 0.9020171, 0.00000, 0.00000, 0,
     {0.966616f, 0.973443f, 0.130037f, 0.957334f, 0.954507f, 0.964725f}},
    {"black and white", false, 67.0f, 0.9673918, 0.00000, 0.00000, 0,
     {0.967392f, 0.967392f, 0.967392f, 0.967392f, 0.967392f, 0.967392f}},
    {"far noise", false, 100.0f, 0.3397212, 0.00000, 0.00000, 0,
     {0.508103f, 0.782271f, 0.444928f, 0.427881f, 0.254808f, 0.262070f}},
    {"near noise", false, 25.5f, 0.8029937, 0.00000, 0.00000, 0,
     {0.473467f, 0.973282f, 0.967310f, 0.699549f, 0.317756f, 0.553344f}},
    {"hdr noise", true, 67.0f, 0.0714110, -6.21496, 5.13300, 12,
     {0.026236f, 0.242423f, 0.089005f, 0.043191f, 0.046018f, 0.061697f}},
    {"hdr brighter", true, 67.0f, 0.1340830, -6.21496, 5.13300, 12,
     {0.043859f, 0.145351f, 0.144902f, 0.071743f, 0.100486f, 0.145938f}},
    {"hdr black", true, 67.0f, 0.0485881, 0.03343, 24.08330, 25,
     {0.258640f, 0.000000f, 0.000000f, 0.000000f, 0.180463f, 0.000000f}},
    {"hdr half black", true, 67.0f, 0.7088697, 0.03274, 11.04908, 12,
     {0.315714f, 0.951316f, 0.951316f, 0.951316f, 0.191191f, 0.951316f}},
};

} // namespace openltc::image::test
