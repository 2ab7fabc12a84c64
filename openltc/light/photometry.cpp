// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/photometry.h"

#include "openltc/light/ldt.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <fstream>

namespace openltc::light {

namespace {

constexpr std::uintmax_t k_max_bytes = 16u << 20;

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

} // namespace

bool is_photometric_name(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".ies" || extension == ".ldt";
}

Result<IesProfile> parse_photometry(std::string_view text, const std::string& name) {
  return extension_of(name) == ".ldt" ? parse_ldt(text, name) : parse_ies(text, name);
}

Result<IesProfile> read_photometry(const std::string& path) {
  std::error_code ec;
  const auto status = std::filesystem::status(path, ec);
  if (ec || !std::filesystem::exists(status))
    return Error{fmt::format("{}: there is no such file", path)};
  // To open a pipe is to wait for its other end.
  if (!std::filesystem::is_regular_file(status))
    return Error{fmt::format("{}: is no regular file", path)};
  const std::uintmax_t size = std::filesystem::file_size(path, ec);
  if (!ec && size > k_max_bytes)
    return Error{fmt::format("{}: {} bytes are more than any photometric file has", path, size)};
  std::ifstream file(path, std::ios::binary);
  if (ec || !file) return Error{fmt::format("{}: cannot be read", path)};
  std::string text(std::size_t(size), '\0');
  if (!file.read(text.data(), std::streamsize(size)))
    return Error{fmt::format("{}: cannot be read", path)};
  return parse_photometry(text, path);
}

} // namespace openltc::light
