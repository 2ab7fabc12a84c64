// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/exr/exr_input.h"

#include "openltc/image/exr/exr_header.h"
#include "openltc/image/file.h"

#include <ImfHeader.h>

#include <cstring>
#include <stdexcept>

namespace openltc::image {

namespace {

// No picture within the limits of file.h has more bytes: four times four channels, uncompressed.
constexpr std::uint64_t k_max_bytes = std::uint64_t(k_max_pixels) * 64;
// No sensible header has more; a damaged one is not read further.
constexpr std::uint64_t k_max_header = std::uint64_t(64) << 20;
constexpr std::size_t k_block = std::size_t(1) << 16;

void limit_header_sizes() {
  static const bool done = [] {
    Imf::Header::setMaxImageSize(k_max_side, k_max_side);
    Imf::Header::setMaxTileSize(8192, 8192); // a tile is held in memory as a whole
    return true;
  }();
  (void)done;
}

Status check_beginning(ExrStream& stream, const std::string& name) {
  std::uint8_t magic[4] = {};
  const std::size_t got = stream.read_at(0, magic);
  if (got == 0) return Error{fmt::format("{}: the file is empty", name)};
  if (got < 4 || magic[0] != 0x76 || magic[1] != 0x2f || magic[2] != 0x31 || magic[3] != 0x01)
    return Error{fmt::format("{}: not an OpenEXR file", name)};
  // Before the library takes what the headers ask for. Most are short, so they are looked at in
  // growing pieces.
  const std::uint64_t most = std::min(stream.size(), k_max_header);
  std::vector<std::uint8_t> head;
  for (std::uint64_t ask = k_block;; ask *= 16) {
    head.resize(std::size_t(std::min(ask, most)));
    head.resize(stream.read_at(0, head));
    if (exr_header_fits(head, stream.size())) return Success{};
    if (ask >= most)
      return Error{fmt::format("{}: the header is damaged or no OpenEXR header", name)};
  }
}

Result<ExrFile> open(std::unique_ptr<ExrStream> stream, const std::string& name) {
  return guarded_exr<ExrFile>(name, "read", [&]() -> Result<ExrFile> {
    limit_header_sizes();
    if (Status ok = check_beginning(*stream, name); !ok) return ok.error();
    ExrFile file;
    file.stream = std::move(stream);
    file.parts = std::make_unique<Imf::MultiPartInputFile>(*file.stream);
    return file;
  });
}

} // namespace

ExrStream::ExrStream(RegularFile file) : Imf::IStream("picture"), file_(std::move(file)) {}

ExrStream::ExrStream(std::span<const std::uint8_t> bytes)
    : Imf::IStream("picture"), bytes_(bytes) {}

std::size_t ExrStream::read_at(std::uint64_t offset, std::span<std::uint8_t> to) {
  if (file_) {
    const Result<std::size_t> got = file_->read_at(offset, to);
    if (!got) throw std::runtime_error(got.error().message);
    return *got;
  }
  if (offset >= bytes_.size()) return 0;
  const std::size_t count = std::min(to.size(), bytes_.size() - std::size_t(offset));
  std::memcpy(to.data(), bytes_.data() + offset, count);
  return count;
}

bool ExrStream::read(char data[], int count) {
  if (count < 0) throw std::runtime_error("a negative number of bytes");
  const std::span<std::uint8_t> to(reinterpret_cast<std::uint8_t*>(data), std::size_t(count));
  std::size_t got = 0;
  if (to.size() >= k_block || !file_) {
    got = read_at(at_, to);
  } else {
    if (at_ < block_at_ || at_ - block_at_ + to.size() > block_.size()) {
      block_.resize(k_block);
      block_at_ = at_;
      block_.resize(read_at(at_, block_));
    }
    const std::size_t begin = std::size_t(at_ - block_at_);
    got = std::min(to.size(), block_.size() - std::min(begin, block_.size()));
    if (got > 0) std::memcpy(to.data(), block_.data() + begin, got);
  }
  if (got < to.size()) throw std::runtime_error("unexpected end of file");
  at_ += to.size();
  return at_ < size();
}

Result<ExrFile> open_exr(const std::string& path) {
  Result<RegularFile> file = open_regular_file(path, k_max_bytes);
  if (!file) return file.error();
  return open(std::make_unique<ExrStream>(std::move(*file)), path);
}

Result<ExrFile> open_exr(std::span<const std::uint8_t> bytes, const std::string& name) {
  return open(std::make_unique<ExrStream>(bytes), name);
}

} // namespace openltc::image
