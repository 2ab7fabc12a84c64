// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/photometry/photometry.h"

#include "openltc/base/regular_file.h"
#include "openltc/light/photometry/ldt.h"

#include <cctype>
#include <filesystem>

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
  const Result<std::string> text = read_regular_text(path, k_max_bytes);
  if (!text) return text.error();
  return parse_photometry(*text, path);
}

} // namespace openltc::light
