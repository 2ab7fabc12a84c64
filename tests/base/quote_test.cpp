// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/quote.h"

#include <doctest/doctest.h>

using openltc::escaped;
using openltc::quote;

TEST_CASE("plain_text_is_shown_as_it_is") {
  for (const char* text : {"", "Lamp", "Lampe d'été", "灯", "a\\b", "\"x\"", "🔦"})
    CHECK(escaped(text) == text);
}

TEST_CASE("what_would_end_a_line_or_steer_a_terminal_is_escaped") {
  CHECK(escaped("a\nb\rc\td") == "a\\nb\\rc\\td");
  CHECK(escaped("\x1b[31m") == "\\x1B[31m");
  CHECK(escaped(std::string_view("\0\x7f", 2)) == "\\x00\\x7F");
  CHECK(escaped("\xc2\x85") == "\\u0085");     // next line
  CHECK(escaped("\xe2\x80\xa8") == "\\u2028"); // line separator
  CHECK(escaped("\xe2\x80\xae"
                "gpj.exe") == "\\u202Egpj.exe"); // right to left
}

TEST_CASE("bytes_that_are_no_utf8_are_escaped_one_by_one") {
  CHECK(escaped("\xff") == "\\xFF");
  CHECK(escaped("\xc3") == "\\xC3");          // cut short
  CHECK(escaped("\xc0\xaf") == "\\xC0\\xAF"); // an overlong '/'
  CHECK(escaped("\xe0\x80\xaf") == "\\xE0\\x80\\xAF");
  CHECK(escaped("\xed\xa0\x80") == "\\xED\\xA0\\x80"); // half of a surrogate pair
  CHECK(escaped("\xf5\x80\x80\x80") == "\\xF5\\x80\\x80\\x80");
  CHECK(escaped("\xc3(") == "\\xC3(");
}

TEST_CASE("long_text_is_cut_at_a_whole_character") {
  CHECK(quote(std::string(100000, 'a')) == std::string(openltc::k_longest_quote, 'a') + "...");
  CHECK(quote("abcdef", 6) == "abcdef");
  CHECK(quote("abcdef", 5) == "abcde...");
  CHECK(quote("abcé", 4) == "abc...");
  CHECK(quote("abcé", 5) == "abcé");
}
