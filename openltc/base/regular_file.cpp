// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/regular_file.h"

#include "openltc/base/file_observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#include <utility>

namespace openltc {

namespace {

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  return "no regular file";
}

Error failure(const std::string& path, const std::string& text) {
  return Error{fmt::format("{}: {}", path, text)};
}

Error not_regular(const std::string& path, mode_t mode) {
  return failure(
      path, fmt::format("is {}; only regular files are read, so save it as one", kind_of(mode)));
}

// Bytes asked for at a time; some systems refuse 2 GiB and more.
constexpr std::size_t k_block = std::size_t(1) << 26;

template <class Container>
Result<Container> read_all(const std::string& path, std::uint64_t max_bytes) try {
  const Result<RegularFile> file = open_regular_file(path, max_bytes);
  if (!file) return file.error();
  Container bytes;
  // What a file says of its size may be wrong: those in /proc say 0, and a log may grow.
  if (file->size() >= bytes.max_size()) throw std::bad_alloc();
  bytes.reserve(std::size_t(file->size()) + 1); // the one byte more shows where the file ends
  bytes.resize(std::size_t(file->size()));
  for (std::size_t have = 0;;) {
    if (have == bytes.size()) bytes.resize(have + (have == file->size() ? 1 : k_block));
    const std::size_t ask = std::min(bytes.size() - have, k_block);
    const Result<std::size_t> got =
        file->read_at(have, {reinterpret_cast<std::uint8_t*>(bytes.data()) + have, ask});
    if (!got) return got.error();
    have += *got;
    if (have > max_bytes)
      return failure(path, fmt::format("more than the {} bytes that are read", max_bytes));
    if (*got < ask) {
      bytes.resize(have);
      return bytes;
    }
  }
} catch (const std::bad_alloc&) {
  return failure(path, "not enough memory to read it");
} catch (const std::length_error&) {
  return failure(path, "not enough memory to read it");
}

} // namespace

RegularFile::RegularFile(std::string path, int descriptor, std::uint64_t size)
    : path_(std::move(path)), descriptor_(descriptor), size_(size) {}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

RegularFile& RegularFile::operator=(RegularFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  return *this;
}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<std::size_t> RegularFile::read_at(std::uint64_t offset, std::span<std::uint8_t> to) const {
  std::size_t have = 0;
  while (have < to.size()) {
    const ssize_t got = ::pread(descriptor_, to.data() + have, std::min(to.size() - have, k_block),
                                off_t(offset + have));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failure(path_, fmt::format("cannot be read: {}", std::strerror(errno)));
    if (got == 0) break;
    have += std::size_t(got);
  }
  return have;
}

Result<RegularFile> open_regular_file(const std::string& path, std::uint64_t max_bytes) {
  if (path.find('\0') != std::string::npos)
    return failure(path.substr(0, path.find('\0')), "a path cannot hold a zero byte");
  // Some devices act when they are opened (a tape rewinds), so the first look is from outside.
  struct stat facts = {};
  if (::stat(path.c_str(), &facts) == 0 && !S_ISREG(facts.st_mode))
    return not_regular(path, facts.st_mode);
  // What has become a pipe since then is opened without waiting for its other end.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return failure(path, fmt::format("cannot open: {}", std::strerror(errno)));
  RegularFile file(path, descriptor, 0);
  if (::fstat(descriptor, &facts) != 0)
    return failure(path, fmt::format("cannot open: {}", std::strerror(errno)));
  if (!S_ISREG(facts.st_mode)) return not_regular(path, facts.st_mode);
  file_observer().reads(path);
  file.size_ = std::uint64_t(std::max<off_t>(facts.st_size, 0));
  if (file.size_ > max_bytes)
    return failure(path,
                   fmt::format("{} bytes, more than the {} that are read", file.size_, max_bytes));
  return file;
}

Result<std::vector<std::uint8_t>> read_regular_file(const std::string& path,
                                                    std::uint64_t max_bytes) {
  return read_all<std::vector<std::uint8_t>>(path, max_bytes);
}

Result<std::string> read_regular_text(const std::string& path, std::uint64_t max_bytes) {
  return read_all<std::string>(path, max_bytes);
}

} // namespace openltc
