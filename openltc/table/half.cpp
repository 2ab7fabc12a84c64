// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/half.h"

#include <bit>

namespace openltc::table {

std::uint16_t half_from_float(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 16 & 0x8000u;
  const std::uint32_t exponent = bits >> 23 & 0xffu; // of 2^(exponent - 127)
  const std::uint32_t mantissa = bits & 0x7fffffu;
  if (exponent == 0xff) return std::uint16_t(sign | 0x7c00u | (mantissa != 0 ? 0x200u : 0u));

  // 24 significant bits, of which the half keeps those above `shift`.
  std::uint32_t significand = mantissa | (exponent != 0 ? 0x800000u : 0u);
  std::uint32_t half = 0;
  int shift = 13;
  if (exponent >= 113) { // 2^-14: normal
    half = (exponent - 112) << 10;
    significand &= 0x7fffffu; // the leading bit is implied
  } else {
    shift += int(113 - exponent);
    if (shift > 25) return std::uint16_t(sign); // less than half of the smallest subnormal
  }
  if (exponent > 143) return std::uint16_t(sign | 0x7c00u);
  half += significand >> shift;
  // Round to nearest, ties to even; a carry runs into the exponent, as it should.
  const std::uint32_t rest = significand & ((1u << shift) - 1), middle = 1u << (shift - 1);
  if (rest > middle || (rest == middle && (half & 1u) != 0)) ++half;
  return std::uint16_t(sign | (half < 0x7c00u ? half : 0x7c00u));
}

float float_from_half(std::uint16_t half) {
  const std::uint32_t sign = std::uint32_t(half & 0x8000u) << 16;
  const std::uint32_t exponent = half >> 10 & 0x1fu, mantissa = half & 0x3ffu;
  if (exponent == 0x1f) return std::bit_cast<float>(sign | 0x7f800000u | mantissa << 13);
  if (exponent != 0) return std::bit_cast<float>(sign | (exponent + 112) << 23 | mantissa << 13);
  const float subnormal = float(mantissa) * 0x1p-24f;
  return sign != 0 ? -subnormal : subnormal;
}

} // namespace openltc::table
