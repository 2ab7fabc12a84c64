// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/temporary_file.h"

#include "openltc/base/file_observer.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace openltc {

namespace {

std::atomic<bool> g_plain{false};
std::atomic<unsigned> g_counter{0};

std::string path_of(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

// A name may have 255 bytes; a long label must not make this one too long.
std::string hidden_name(const std::string& folder, const std::string& label) {
  return fmt::format("{}/.{}.{}-{}.part", folder, label.substr(0, 100), ::getpid(),
                     g_counter.fetch_add(1));
}

// Closed by itself only in the child of a fork; -1 with errno set.
int open_unnamed(const std::string& folder) {
#ifdef O_TMPFILE
  if (g_plain.load()) return -1;
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  // Without /proc it could neither be opened by path nor get a name.
  if (descriptor >= 0 && ::access(path_of(descriptor).c_str(), F_OK) == 0) return descriptor;
  if (descriptor >= 0) ::close(descriptor);
#else
  (void)folder;
#endif
  return -1;
}

} // namespace

void assume_plain_file_system(bool plain) { g_plain.store(plain); }

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), folder_(std::move(other.folder_)),
      label_(std::move(other.label_)), name_(std::exchange(other.name_, {})),
      new_mode_(other.new_mode_) {}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(folder_, other.folder_);
  std::swap(label_, other.label_);
  std::swap(name_, other.name_);
  std::swap(new_mode_, other.new_mode_);
  return *this;
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (name_.empty()) return;
  const Undivided undivided;
  ::unlink(name_.c_str());
  file_observer().ends_unfinished(name_);
}

std::string TemporaryFile::path() const { return name_.empty() ? path_of(descriptor_) : name_; }

bool TemporaryFile::link_as(const std::string& path) {
  if (name_.empty())
    return ::linkat(AT_FDCWD, path_of(descriptor_).c_str(), AT_FDCWD, path.c_str(),
                    AT_SYMLINK_FOLLOW) == 0;
  return ::linkat(AT_FDCWD, name_.c_str(), AT_FDCWD, path.c_str(), 0) == 0;
}

bool TemporaryFile::give_name() {
  if (!name_.empty()) return true;
  const std::string name = hidden_name(folder_, label_);
  const Undivided undivided;
  if (!link_as(name)) return false;
  name_ = name;
  file_observer().makes_unfinished(name_);
  return true;
}

bool TemporaryFile::rename_to(const std::string& path) {
  const Undivided undivided;
  if (!give_name() || ::rename(name_.c_str(), path.c_str()) != 0) return false;
  file_observer().ends_unfinished(name_);
  name_.clear();
  return true;
}

bool TemporaryFile::change_places_with(const std::string& path) {
  const Undivided undivided;
  struct stat there = {};
  if (::lstat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode)) { // become so meanwhile
    errno = S_ISDIR(there.st_mode) ? EISDIR : EBUSY;                   // an exchange would take it
    return false;
  }
  if (!give_name()) return false;
#ifdef RENAME_EXCHANGE
  if (!g_plain.load()) {
    if (::renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, path.c_str(), RENAME_EXCHANGE) == 0)
      return true;
    if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP) return false;
  }
#endif
  // Two steps where the file system has none for it: a second name for the old file, then the name.
  const std::string old = hidden_name(folder_, label_);
  const bool kept = ::link(path.c_str(), old.c_str()) == 0; // FAT has no second names
  if (!kept && errno == ENOENT) return false;
  if (::rename(name_.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    if (kept) ::unlink(old.c_str());
    errno = reason;
    return false;
  }
  file_observer().ends_unfinished(name_);
  name_ = kept ? old : "";
  if (kept) file_observer().makes_unfinished(old);
  return true;
}

bool TemporaryFile::put_back(const std::string& path) {
  const Undivided undivided;
  if (name_.empty() || ::rename(name_.c_str(), path.c_str()) != 0) return false;
  file_observer().ends_unfinished(name_);
  name_.clear();
  return true;
}

Result<TemporaryFile> make_temporary_file(const std::string& folder, const std::string& label) {
  TemporaryFile file;
  file.folder_ = folder;
  file.label_ = label;
  file.descriptor_ = open_unnamed(folder);
  if (file.descriptor_ < 0) {
    const std::string name = hidden_name(folder, label);
    const Undivided undivided;
    file.descriptor_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
    if (file.descriptor_ >= 0) {
      file.name_ = name;
      file_observer().makes_unfinished(name);
    }
  }
  struct stat facts = {};
  if (file.descriptor_ < 0 || ::fstat(file.descriptor_, &facts) != 0)
    return Error{std::strerror(errno)};
  file.new_mode_ = facts.st_mode & 0777;
  ::fchmod(file.descriptor_, 0600); // what it replaces may be private
  return file;
}

} // namespace openltc
