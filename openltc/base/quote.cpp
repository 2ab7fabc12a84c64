// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// UTF-8: RFC 3629. Marks of writing direction: Unicode Standard Annex 9, section 2.

#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <cstdint>

namespace openltc {

namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 1;
  bool is_valid = false;
};

// The character at the beginning of `text`, which is not empty.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(text[i])); };
  const std::uint32_t head = byte(0);
  if (head < 0x80) return {head, 1, true};
  const std::size_t size = head >= 0xF0 ? 4 : head >= 0xE0 ? 3 : 2;
  if (head < 0xC2 || head > 0xF4 || text.size() < size) return {head, 1, false};
  std::uint32_t code = head & (0xFFu >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {head, 1, false};
    code = code << 6 | (byte(i) & 0x3F);
  }
  const bool is_too_long = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (is_too_long || is_surrogate || code > 0x10FFFF) return {head, 1, false};
  return {code, size, true};
}

bool is_harmful(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x61C || code == 0x200E ||
         code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string escape_of(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  return code < 0x80 ? fmt::format("\\x{:02X}", code) : fmt::format("\\u{:04X}", code);
}

std::string shown(std::string_view text, std::size_t longest) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = first_of(text.substr(at));
    if (at + c.size > longest) return out + "...";
    if (!c.is_valid)
      out += fmt::format("\\x{:02X}", c.code);
    else if (is_harmful(c.code))
      out += escape_of(c.code);
    else
      out += text.substr(at, c.size);
    at += c.size;
  }
  return out;
}

} // namespace

std::string escaped(std::string_view text) { return shown(text, text.size()); }

std::string quote(std::string_view text, std::size_t longest) {
  return shown(text, text.size() <= longest ? text.size() : longest);
}

} // namespace openltc
