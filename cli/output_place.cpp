// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/output_place.h"

#include "cli/process/input_files.h"
#include "openltc/base/destination.h"
#include "openltc/base/file_place.h"

#include <fmt/format.h>

#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace openltc::cli {

namespace {

// Pipes and devices take from several, files do not.
bool is_file_of(int stream, const FilePlace& place) {
  struct stat facts = {};
  return ::fstat(stream, &facts) == 0 && S_ISREG(facts.st_mode) &&
         place == FilePlace{std::uint64_t(facts.st_dev), std::uint64_t(facts.st_ino), ""};
}

bool is_stream(const std::string& path) {
  struct stat facts = {};
  return ::stat(path.c_str(), &facts) == 0 && (S_ISFIFO(facts.st_mode) || S_ISCHR(facts.st_mode));
}

} // namespace

Status check_place(const std::string& path) { return check_destination(path); }

Status check_places(const std::vector<std::string>& files) {
  std::set<FilePlace> seen;
  for (const std::string& file : files) {
    if (Status status = check_place(file); !status.ok()) return status;
    const FilePlace place = place_of(file);
    if (!is_stream(file) && !seen.insert(place).second)
      return Error{
          fmt::format("{}: would be written twice; give each output a name of its own", file)};
    if (is_file_of(STDOUT_FILENO, place) || is_file_of(STDERR_FILENO, place))
      return Error{fmt::format("{}: standard {} goes there as well; give one of them another name",
                               file, is_file_of(STDOUT_FILENO, place) ? "output" : "error")};
  }
  return check_not_read(files);
}

Status check_not_read(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (is_input(place_of(file)))
      return Error{fmt::format("{}: is also an input, which would be lost; give the output another "
                               "name",
                               file)};
  return Success{};
}

} // namespace openltc::cli
