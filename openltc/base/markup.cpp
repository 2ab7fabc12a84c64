// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/markup.h"

#include <cmath>

namespace openltc {

std::string markup_text(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) {
      return i + k < text.size() ? std::uint8_t(text[i + k]) : std::uint8_t(0);
    };
    const std::uint8_t c = byte(0);
    std::size_t size = 1;
    if (c >= 0x80) {
      size = c >= 0xc2 && c < 0xe0 ? 2 : c >= 0xe0 && c < 0xf0 ? 3 : c >= 0xf0 && c < 0xf5 ? 4 : 0;
      for (std::size_t k = 1; k < size; ++k)
        if ((byte(k) & 0xc0) != 0x80) size = 0;
      // Overlong forms, surrogates and what lies beyond U+10FFFF.
      if ((c == 0xe0 && byte(1) < 0xa0) || (c == 0xed && byte(1) > 0x9f) ||
          (c == 0xf0 && byte(1) < 0x90) || (c == 0xf4 && byte(1) > 0x8f))
        size = 0;
    } else if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7f) {
      size = 0;
    }
    if (size == 0) {
      out += "\xef\xbf\xbd";
      ++i;
      continue;
    }
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\'':
      out += "&#39;";
      break;
    default:
      out += text.substr(i, size);
    }
    i += size;
  }
  return out;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view k_digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t word = (std::uint32_t(bytes[i]) << 16) |
                               (left > 1 ? std::uint32_t(bytes[i + 1]) << 8 : 0u) |
                               (left > 2 ? std::uint32_t(bytes[i + 2]) : 0u);
    text += k_digits[(word >> 18) & 63];
    text += k_digits[(word >> 12) & 63];
    text += left > 1 ? k_digits[(word >> 6) & 63] : '=';
    text += left > 2 ? k_digits[word & 63] : '=';
  }
  return text;
}

double round_step(double range, int count) {
  const double raw = range / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (raw <= factor * power * 1.0001) return factor * power;
  return 10 * power;
}

} // namespace openltc
