// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "merl_file.h"

#include "directions.h"

#include <bit>
#include <cmath>

namespace openltc::test {

namespace {

void append(std::vector<std::uint8_t>& bytes, std::uint64_t value, int n) {
  for (int i = 0; i < n; ++i)
    bytes.push_back(std::uint8_t(value >> (8 * i)));
}

} // namespace

std::vector<std::uint8_t> merl_bytes(const std::array<std::int32_t, 3>& counts,
                                     const std::vector<double>& samples) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(12 + 8 * samples.size());
  for (const std::int32_t n : counts)
    append(bytes, std::uint32_t(n), 4);
  for (const double sample : samples)
    append(bytes, std::bit_cast<std::uint64_t>(sample), 8);
  return bytes;
}

std::vector<double> merl_samples(const std::array<std::int32_t, 3>& counts, const brdf::Brdf& brdf,
                                 double roughness) {
  std::vector<double> samples;
  for (const double per_unit : {1500.0, 1500.0 / 1.15, 1500.0 / 1.66}) {
    for (int h = 0; h < counts[0]; ++h) {
      for (int d = 0; d < counts[1]; ++d) {
        for (int p = 0; p < counts[2]; ++p) {
          const double share = (h + 0.5) / counts[0];
          const double theta_h = 0.5 * f64::k_pi * share * share;
          const Vec3d diff =
              direction(0.5 * f64::k_pi * (d + 0.5) / counts[1], f64::k_pi * (p + 0.5) / counts[2]);
          // Turn the half vector's frame, in which wi = diff, by theta_h about y.
          const double c = std::cos(theta_h), s = std::sin(theta_h);
          const auto turned = [&](Vec3d w) {
            return Vec3d(c * w.x + s * w.z, w.y, -s * w.x + c * w.z);
          };
          const Vec3d wi = turned(diff), wo = turned(mirrored(diff));
          const bool above = wi.z > 0 && wo.z > 0;
          samples.push_back(above ? brdf.eval(wo, wi, roughness).scale / wi.z * per_unit : -1);
        }
      }
    }
  }
  return samples;
}

} // namespace openltc::test
