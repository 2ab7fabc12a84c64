// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/destination.h"

#include "openltc/base/file_place.h"
#include "openltc/base/temporary_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace openltc {

namespace fs = std::filesystem;

namespace {

Error failure(const std::string& path, const std::string& text) {
  return Error{fmt::format("{}: {}", path, text)};
}

// What would let rename() fail hours later though the folder takes new files.
Status check_replaceable(const std::string& path, const Destination& to) {
  struct stat folder = {};
  const uid_t user = ::geteuid();
  if (::stat(to.folder.c_str(), &folder) == 0 && (folder.st_mode & S_ISVTX) != 0 && user != 0 &&
      user != folder.st_uid && user != to.facts.st_uid)
    return failure(path, "belongs to another user, and so does its folder, where only owners may "
                         "replace files; give another name");
#ifdef STATX_ATTR_MOUNT_ROOT
  struct statx more = {};
  if (::statx(AT_FDCWD, to.path.c_str(), 0, STATX_BASIC_STATS, &more) != 0) return Success{};
  if ((more.stx_attributes & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) != 0)
    return failure(path, "cannot be replaced: immutable or append-only (lsattr shows it)");
  if ((more.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0)
    return failure(path, "cannot be replaced: a mount of its own; mount its folder instead");
#endif
  return Success{};
}

} // namespace

Result<Destination> find_destination(const std::string& path) {
  if (path.empty()) return Error{"the output path is empty"};
  Destination to;
  to.path = without_dangling_links(path);
  const bool is_there = ::stat(to.path.c_str(), &to.facts) == 0;
  if (!is_there && errno != ENOENT && errno != ENOTDIR)
    return failure(path, fmt::format("cannot be written: {}", std::strerror(errno)));
  const mode_t mode = to.facts.st_mode;
  if (is_there) {
    if (S_ISDIR(mode)) return failure(path, "is a directory");
    if (S_ISBLK(mode) || S_ISSOCK(mode))
      return failure(path, fmt::format("is a {}, where no file can be written",
                                       S_ISBLK(mode) ? "block device" : "socket"));
    to.exists = S_ISREG(mode);
    to.is_stream = !to.exists;
    std::error_code ec;
    if (to.exists) to.path = fs::canonical(to.path, ec).string();
    struct stat found = {};
    if (to.exists && (ec || ::stat(to.path.c_str(), &found) != 0 ||
                      found.st_ino != to.facts.st_ino || found.st_dev != to.facts.st_dev))
      return failure(path, "cannot be written: the file that it points to has no name");
  } else if (fs::path(to.path).filename().empty()) {
    return failure(path, "names a folder, not a file");
  }
  to.folder = fs::path(to.path).parent_path().string();
  if (to.folder.empty()) to.folder = ".";
  std::error_code ec;
  if (!fs::is_directory(to.folder, ec))
    return failure(path, fmt::format("the folder {} does not exist", to.folder));
  // What is protected from `>` is protected from us, though the folder would let us replace it.
  if (is_there && ::faccessat(AT_FDCWD, to.path.c_str(), W_OK, AT_EACCESS) != 0)
    return failure(path, fmt::format("may not be written: {}{}", std::strerror(errno),
                                     errno == EACCES ? "; chmod u+w it or give another name" : ""));
  return to;
}

Status check_destination(const std::string& path) {
  const Result<Destination> to = find_destination(path);
  if (!to) return to.error();
  if (to->is_stream) return Success{};
  if (to->exists)
    if (Status status = check_replaceable(path, *to); !status.ok()) return status;
  // Permission bits do not tell all (root, read-only and virtual file systems): try it.
  const Result<TemporaryFile> probe = make_temporary_file(to->folder, "probe");
  if (!probe)
    return failure(
        path, fmt::format("cannot write in the folder {}: {}", to->folder, probe.error().message));
  return Success{};
}

} // namespace openltc
