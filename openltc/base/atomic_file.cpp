// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/atomic_file.h"

#include "openltc/base/destination.h"
#include "openltc/base/file_observer.h"
#include "openltc/base/temporary_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/xattr.h>
#include <unistd.h>

namespace openltc {

struct FileGroup::Member {
  std::string path; ///< as the caller names it
  Destination to;
  TemporaryFile file;
  bool replaced = false; ///< file holds what was at `to` before
  bool made = false;     ///< nothing was there before
};

namespace {

thread_local FileGroup* t_group = nullptr;

Error cannot_write(const std::string& path, int reason) {
  if (reason == EEXIST)
    return Error{
        fmt::format("{}: would be written twice; give each output a name of its own", path)};
  return Error{fmt::format("{}: cannot write: {}", path, std::strerror(reason))};
}

// An access list gives the permission bits another meaning: without it the group's bits, which are
// then its mask, would let the whole group in.
bool copy_access_list(const std::string& from, int to) {
  constexpr const char* k_name = "system.posix_acl_access";
  const ssize_t size = ::getxattr(from.c_str(), k_name, nullptr, 0);
  if (size <= 0) return true; // none, or a file system without them
  std::string list(std::size_t(size), '\0');
  return ::getxattr(from.c_str(), k_name, list.data(), list.size()) == size &&
         ::fsetxattr(to, k_name, list.data(), list.size(), 0) == 0;
}

// The owner, group and permission bits of the file that is replaced, or of a new one.
void set_access(const Destination& to, const TemporaryFile& file) {
  const int descriptor = file.descriptor();
  unsigned mode = file.new_mode();
  if (to.exists) {
    mode = to.facts.st_mode & 0777;
    struct stat mine = {};
    if (::fstat(descriptor, &mine) != 0) mine = {};
    const bool same_group =
        mine.st_gid == to.facts.st_gid || ::fchown(descriptor, uid_t(-1), to.facts.st_gid) == 0;
    // Another group gets no more than everybody had.
    if (!same_group) mode = (mode & 0707) | ((mode & 07) << 3);
    if (mine.st_uid != to.facts.st_uid && ::fchown(descriptor, to.facts.st_uid, gid_t(-1)) != 0)
      mode |= 0600; // only root gives files away: it is ours now
    if (!copy_access_list(to.path, descriptor)) mode &= 0707;
  }
  ::fchmod(descriptor, mode);
}

// Into a pipe or device, from the beginning.
bool pour(int from, const std::string& path) {
  const int to = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (to < 0) return false;
  std::vector<char> block(std::size_t(1) << 16);
  off_t at = 0;
  ssize_t got = 0;
  bool good = true;
  while (good && (got = ::pread(from, block.data(), block.size(), at)) > 0) {
    for (ssize_t done = 0; good && done < got;) {
      const ssize_t written = ::write(to, block.data() + done, std::size_t(got - done));
      if (written < 0 && errno == EINTR) continue;
      good = written >= 0;
      done += written;
    }
    at += got;
  }
  const int reason = errno;
  const bool closed = ::close(to) == 0;
  if (!good || got < 0) errno = reason;
  return good && got == 0 && closed;
}

// The system has no such step for this kind of file; anything else is an error.
bool flush_to_disk(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP;
}

} // namespace

FileGroup::FileGroup() : outer_(t_group) { t_group = this; }

FileGroup::~FileGroup() { t_group = outer_; }

Status FileGroup::commit() {
  if (outer_) {
    std::move(members_.begin(), members_.end(), std::back_inserter(outer_->members_));
    members_.clear();
    return Success{};
  }
  for (const auto& m : members_)
    if (m->to.is_stream && !pour(m->file.descriptor(), m->to.path))
      return cannot_write(m->path, errno);

  const Undivided undivided;
  const auto is_of_this_group = [&](const std::string& path) {
    struct stat there = {}, mine = {};
    if (::stat(path.c_str(), &there) != 0) return false;
    for (const auto& m : members_)
      if ((m->made || m->replaced) && ::fstat(m->file.descriptor(), &mine) == 0 &&
          mine.st_ino == there.st_ino && mine.st_dev == there.st_dev)
        return true;
    return false;
  };
  const auto put_in_place = [&](Member& m) {
    // The directory may hold two spellings for one, where case does not count.
    if (is_of_this_group(m.to.path)) {
      errno = EEXIST;
      return false;
    }
    if (!m.to.exists && m.file.link_as(m.to.path)) return m.made = true;
    if (m.file.change_places_with(m.to.path)) return m.replaced = true;
    return errno == ENOENT && m.file.rename_to(m.to.path) && (m.made = true);
  };
  for (const auto& m : members_) {
    if (m->to.is_stream || put_in_place(*m)) continue;
    const int reason = errno;
    for (auto back = members_.rbegin(); back != members_.rend(); ++back) {
      if ((*back)->made) ::unlink((*back)->to.path.c_str());
      if ((*back)->replaced) (*back)->file.put_back((*back)->to.path);
    }
    return cannot_write(m->path, reason);
  }
  if (!members_.empty()) file_observer().has_written();
  members_.clear();
  return Success{};
}

Status write_atomically(const std::string& path,
                        const std::function<Status(const std::string& temporary)>& write) {
  namespace fs = std::filesystem;
  Result<Destination> to = find_destination(path);
  if (!to) return to.error();
  std::error_code ec;
  // What goes into a pipe waits where every program's temporary files lie.
  const std::string folder = to->is_stream ? fs::temp_directory_path(ec).string() : to->folder;
  Result<TemporaryFile> file =
      make_temporary_file(ec ? "." : folder, fs::path(to->path).filename().string());
  if (!file) return Error{fmt::format("{}: cannot write: {}", path, file.error().message)};
  Status status = Success{};
  try {
    status = write(file->path());
  } catch (const std::exception& e) {
    status = Error{fmt::format("{}: {}", path, e.what())};
  } catch (...) {
    status = Error{fmt::format("{}: cannot write", path)};
  }
  if (!status.ok()) return status;
  struct stat made = {};
  if (::fstat(file->descriptor(), &made) != 0 || made.st_size == 0)
    return Error{fmt::format("{}: nothing was written", path)};
  if (!to->is_stream) {
    set_access(*to, *file);
    if (!flush_to_disk(file->descriptor())) return cannot_write(path, errno);
  }
  FileGroup group; // of its own, or a part of the one that is open
  group.members_.push_back(std::make_unique<FileGroup::Member>());
  FileGroup::Member& member = *group.members_.back();
  member.path = path;
  member.to = std::move(*to);
  member.file = std::move(*file);
  return group.commit();
}

Result<std::vector<std::string>> write_files(std::span<const FileBytes> files) {
  FileGroup together;
  std::vector<std::string> paths;
  for (const FileBytes& file : files) {
    const Status status = write_atomically(file.path, [&](const std::string& temporary) -> Status {
      std::ofstream out(temporary, std::ios::binary);
      out.write(reinterpret_cast<const char*>(file.bytes.data()),
                std::streamsize(file.bytes.size()));
      out.close();
      if (!out) return Error{file.path + ": cannot write; is the disk full?"};
      return Success{};
    });
    if (!status) return status.error();
    paths.push_back(file.path);
  }
  if (Status status = together.commit(); !status) return status.error();
  return paths;
}

} // namespace openltc
