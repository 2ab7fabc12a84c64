// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Text of a file as a message shows it. A name may be of any length and hold anything: a line break
// would end the message, an escape sequence would steer the terminal, a mark that turns the
// direction of writing would show something else than what is there.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace openltc {

/// Longest text of a file that a message repeats, in bytes of the original.
inline constexpr std::size_t k_longest_quote = 80;

/// `text` on one line: control characters (C0, DEL, C1), line and paragraph separators, marks of
/// writing direction and bytes that are no UTF-8 become escapes, \n \t \r \x1B \u2028. All else
/// stays, backslashes too.
std::string escaped(std::string_view text);

/// escaped(), and cut at `longest` bytes of the original, at a whole character, with "..." behind.
std::string quote(std::string_view text, std::size_t longest = k_longest_quote);

} // namespace openltc
