// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: G. Ward, "Radiance File Formats", picture file format: the header's variables, of which
// EXPOSURE and COLORCORR are cumulative, and the resolution line.

#include "openltc/image/radiance_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <span>

namespace openltc::image {

namespace {

// Lines may end as Windows ends them, and values stand between spaces.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\v\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

// The next word of `text`, which is taken off.
std::string_view next_word(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, std::min(text.find_first_of(" \t"), text.size()));
  text.remove_prefix(word.size());
  return word;
}

// As many finite numbers as `values` has.
bool parse_numbers(std::string_view text, std::span<double> values) {
  for (double& value : values) {
    const std::string word(next_word(text));
    char* end = nullptr;
    value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value)) return false;
  }
  return true;
}

} // namespace

bool parse_radiance_resolution(std::string_view text, RadianceHeader& header) {
  bool has_x = false, has_y = false;
  for (int axis = 0; axis < 2; ++axis) {
    const std::string_view name = next_word(text), digits = next_word(text);
    if (name.size() != 2 || (name[0] != '+' && name[0] != '-')) return false;
    int length = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), length);
    if (digits.empty() || result.ec != std::errc() || result.ptr != digits.data() + digits.size())
      return false;
    if (name[1] == 'X' && !has_x) {
      has_x = true;
      header.width = length;
      header.from_right = name[0] == '-';
      header.columns = axis == 0;
    } else if (name[1] == 'Y' && !has_y) {
      has_y = true;
      header.height = length;
      header.from_bottom = name[0] == '+';
    } else {
      return false;
    }
  }
  return trimmed(text).empty();
}

Status read_radiance_variable(std::string_view line, const std::string& name,
                              RadianceHeader& header) {
  const std::string_view value = trimmed(line.substr(std::min(line.find('=') + 1, line.size())));
  const auto wrong = [&](const char* what) {
    return Error{fmt::format("{}: the header line '{}' {}", name, line.substr(0, 60), what)};
  };
  if (line.starts_with("FORMAT=")) {
    header.is_xyz = value == "32-bit_rle_xyze";
    if (!header.is_xyz && value != "32-bit_rle_rgbe")
      return wrong("is not supported, only FORMAT=32-bit_rle_rgbe and 32-bit_rle_xyze");
  } else if (line.starts_with("EXPOSURE=")) { // of several, the product
    double exposure = 0;
    if (!parse_numbers(value, {&exposure, 1}) || !(exposure > 0.0 && exposure < 1e30))
      return wrong("is not a positive number");
    header.exposure *= exposure;
  } else if (line.starts_with("COLORCORR=")) { // the same, for each channel
    std::array<double, 3> factors{};
    if (!parse_numbers(value, factors)) return wrong("is not three positive numbers");
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(factors[c] > 0.0 && factors[c] < 1e30)) return wrong("is not three positive numbers");
      header.color_correction[c] *= factors[c];
    }
  } else if (line.starts_with("PRIMARIES=")) {
    std::array<double, 8> v{};
    if (!parse_numbers(value, v)) return wrong("is not eight numbers");
    const bool is_set = std::any_of(v.begin(), v.end(), [](double x) { return x != 0.0; });
    const Primaries primaries{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}};
    if (is_set && !rec709_from_rgb(primaries)) return wrong("is no colour space");
    if (is_set && !is_rec709(primaries)) header.primaries = primaries;
  }
  return Success{};
}

} // namespace openltc::image
