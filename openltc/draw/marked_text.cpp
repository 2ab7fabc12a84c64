// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// SVG 1.1 shifts the base line by dy, for all that follows; there is nothing to end it but the
// opposite shift, which needs a character to stand on.

#include "openltc/draw/marked_text.h"

#include "openltc/base/markup.h"

#include <fmt/format.h>

namespace openltc::draw {

namespace {

// Bytes of the UTF-8 character at the start.
std::size_t character_size(std::string_view text) {
  std::size_t size = 1;
  while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xc0u) == 0x80u)
    ++size;
  return size;
}

} // namespace

std::string marked_text(std::string_view text, double size) {
  const std::string drop = fmt::format("{:.2g}", 0.25 * size);
  std::string result;
  bool slanted = false, lowered = false;
  while (!text.empty()) {
    if (text[0] == '*') {
      result += slanted ? "</tspan>" : "<tspan font-style=\"italic\">";
      slanted = !slanted;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t end = text.find('}');
    if (text.substr(0, 2) == "_{" && end != std::string_view::npos) {
      result += fmt::format("<tspan dy=\"{}\" font-size=\"{:.3g}\">{}</tspan>", drop, 0.72 * size,
                            marked_text(text.substr(2, end - 2), 0.72 * size));
      text.remove_prefix(end + 1);
      lowered = true;
      continue;
    }
    const std::size_t bytes = character_size(text);
    const std::string character = markup_text(text.substr(0, bytes));
    result += lowered ? fmt::format("<tspan dy=\"-{}\">{}</tspan>", drop, character) : character;
    lowered = false;
    text.remove_prefix(bytes);
  }
  return result;
}

} // namespace openltc::draw
