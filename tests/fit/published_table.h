// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The table that most engines ship, read by a few lines of its own, so that nothing of the
// library's readers is trusted here.

#pragma once

#include "openltc/fit/measure/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace openltc::testing {

inline double number_from_half(std::uint16_t h) {
  const int exponent = (h >> 10) & 31, mantissa = h & 1023;
  const double size =
      exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
  return (h & 0x8000) != 0 ? -size : size;
}

/// 64 x 64 RGBA16F behind a DDS header of 128 bytes (no DX10 header); nothing when it is not there.
inline std::optional<std::vector<double>> read_published(const std::string& name) {
  std::ifstream file(std::string(OPENLTC_SHARED_DIR) + "/tables/" + name, std::ios::binary);
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
  const std::size_t count = 64 * 64 * 4;
  if (bytes.size() < count * 2) return std::nullopt;
  std::vector<double> values;
  const std::size_t at = bytes.size() - count * 2;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(number_from_half(
        std::uint16_t(bytes[at + 2 * i] | (unsigned(bytes[at + 2 * i + 1]) << 8))));
  return values;
}

/// (M^-1_00, M^-1_20, M^-1_02, M^-1_22)/M^-1_11 and (n1, n5, ..), u = sqrt(alpha) fast,
/// v = sqrt(1 - cos theta), bilinear between texels i/63.
inline std::optional<fit::LobeFunction> published_lobes() {
  const auto one = read_published("ltc_code_1.dds"), two = read_published("ltc_code_2.dds");
  if (!one || !two) return std::nullopt;
  const auto matrix = std::make_shared<std::vector<double>>(*one);
  const auto amplitude = std::make_shared<std::vector<double>>(*two);
  return [matrix, amplitude](double roughness, double cos_theta) {
    const double u = std::clamp(roughness, 0.0, 1.0) * 63;
    const double v = std::sqrt(1 - std::clamp(cos_theta, 0.0, 1.0)) * 63;
    const auto i = std::size_t(std::min(u, 62.0)), j = std::size_t(std::min(v, 62.0));
    const double x = u - double(i), y = v - double(j);
    const auto read = [&](const std::vector<double>& t, std::size_t channel) {
      const auto texel = [&](std::size_t a, std::size_t b) {
        return t[(b * 64 + a) * 4 + channel];
      };
      return (1 - y) * ((1 - x) * texel(i, j) + x * texel(i + 1, j)) +
             y * ((1 - x) * texel(i, j + 1) + x * texel(i + 1, j + 1));
    };
    f64::FittedLobe fitted;
    fitted.lobe =
        f64::make_lobe(read(*matrix, 0), read(*matrix, 2), read(*matrix, 1), read(*matrix, 3));
    fitted.n1 = read(*amplitude, 0);
    fitted.n5 = read(*amplitude, 1);
    return fitted;
  };
}

} // namespace openltc::testing
