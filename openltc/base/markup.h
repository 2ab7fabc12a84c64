// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What every writer of HTML and SVG needs.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace openltc {

/// Text for HTML and XML, in elements and in quoted attributes. Control characters and bytes that
/// are not UTF-8 become U+FFFD.
std::string markup_text(std::string_view text);

/// Base 64, RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// A round step, 1, 2, 2.5 or 5 times a power of ten, that cuts a range into about `count`.
double round_step(double range, int count);

} // namespace openltc
