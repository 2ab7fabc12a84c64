// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/render/frame_record.h"

#include "openltc/base/atomic_file.h"
#include "openltc/base/regular_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace openltc::cli {

namespace {

constexpr std::uint64_t k_longest_record = 4096;

std::filesystem::path record_of(const std::filesystem::path& file) {
  return file.parent_path() / ".openltc" / (file.filename().string() + ".inputs");
}

// Empty where there is no such file.
std::string record_text(const std::filesystem::path& file, const std::string& fingerprint) {
  std::error_code ec;
  const std::uintmax_t size = std::filesystem::file_size(file, ec);
  return ec ? "" : fmt::format("{}\n{}\n", fingerprint, size);
}

} // namespace

bool is_made_of(const std::vector<std::string>& files, const std::string& fingerprint) {
  for (const std::string& file : files) {
    const Result<std::string> record =
        read_regular_text(record_of(file).string(), k_longest_record);
    if (!record || *record != record_text(file, fingerprint)) return false;
  }
  return true;
}

Status record_made_of(const std::vector<std::string>& files, const std::string& fingerprint) {
  std::vector<FileBytes> records;
  for (const std::string& file : files) {
    const std::filesystem::path record = record_of(file);
    std::error_code ec;
    std::filesystem::create_directory(record.parent_path(), ec);
    records.push_back(file_of_text(record.string(), record_text(file, fingerprint)));
  }
  const Result<std::vector<std::string>> written = write_files(records);
  if (!written) return written.error();
  return Success{};
}

} // namespace openltc::cli
