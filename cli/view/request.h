// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a browser asks for, as far as a server of files has to know: RFC 9112, sections 2.2 to 5.

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace openltc::cli {

/// The head of a request.
struct Request {
  std::string method;
  std::string path; ///< decoded, from "/" on, without query
  std::string host; ///< of the header Host, in lower case; empty where there is not exactly one
};

/// Reads a head, up to and without its empty line. None where it is not one: then the answer is
/// 400. A path that is no valid percent-encoding, or has a byte 0 or a backslash, is none.
std::optional<Request> parse_request(std::string_view head);

/// A file's name as a part of an address: all but letters, digits and -._~ as %XX.
std::string percent_encoded(std::string_view name);

} // namespace openltc::cli
